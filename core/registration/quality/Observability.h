#pragma once

#include <vector>

#include "core/registration/RegistrationQuality.h"
#include "core/registration/quality/PoseInformation.h"

namespace vestige {

/// Eigenvectors of the Hessian: the free ones, then the others, each the least observed first. One is free
/// when the pose's standard deviation along it exceeds `freeSigma_m`, or when the noise of the normals alone
/// would hold it as well. Free ones are turned among themselves so that as many as can be are pure shifts:
/// shifts first, level before upright. `covariance` is of p, about the information's pivot.
std::vector<ObservedDirection> observedDirections(const PoseInformation& information,
                                                  const Matrix6d& covariance, double freeSigma_m);

}  // namespace vestige
