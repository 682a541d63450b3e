#pragma once

#include "core/geometry/PoseUncertainty.h"
#include "core/registration/RegistrationResult.h"
#include "core/scene/Layer.h"

namespace vestige {

/// What a pair counts for in the adjustment: the covariance that its registration gives of itself. Where it
/// gives none, standard deviations of the inliers' residual over the root of the overlap along every axis at
/// the middle of the source, and of that at half the source's extent for the turn: not a true covariance, but
/// one that grows with noise and with little overlap. `source` is the layer whose points were moved.
PoseUncertainty pairUncertainty(const RegistrationResult& result, const Layer& source);

}  // namespace vestige
