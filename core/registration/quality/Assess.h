#pragma once

#include <functional>

#include "core/base/JobControl.h"
#include "core/geometry/PointCloud.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/quality/QualityOptions.h"

namespace vestige {

/// Registers again by the same method, from another first pose.
using RegisterAgain = std::function<Result<Pose>(const Pose& start)>;

/// Fills quality, verdict and reasons of a registration whose pose has been found. It looks at the clouds and
/// at the pose only, not at how it was found: both clouds are cut into planar cells anew, and the pose is
/// held against them. The target is in metres, the source in the unit of the result's scale. The same bits
/// for any number of threads. Throws ErrorException when the job is cancelled.
void assess(RegistrationResult& result, const PointCloud& target, const PointCloud& source,
            const QualityOptions& options, const RegisterAgain& again, const JobControl& control);

}  // namespace vestige
