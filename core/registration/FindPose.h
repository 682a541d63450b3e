#pragma once

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"

namespace vestige {

/// The pose alone, from points in memory, by the method of `registrationParameters()`: no verdict yet. The
/// target is in metres, the source in the unit of `initial.scale`. ErrorCode::untrustworthy when there is
/// nothing to hold on to.
Result<RegistrationResult> findPose(const PointCloud& target, const PointCloud& source,
                                    const Similarity& initial, const ParameterSet& parameters,
                                    const JobControl& control = {}, const RegistrationWatch& watch = {});

}  // namespace vestige
