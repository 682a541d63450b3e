#pragma once

#include <optional>

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"

namespace vestige {

/// A source that shows its surface far more finely than the target does, from a known first pose: a handheld
/// scan in an aerial cloud. The model is then better made of the source: the target's points round it are
/// registered to the source's cells, and the pose is turned round (docs/decisions/0008). The result speaks of
/// the source's pose in the target as ever. Nothing where the source is not such a one, where the user said
/// which cells to take, or where no pose was found that way.
std::optional<Result<RegistrationResult>> findPoseOnDenserSource(
    const PointCloud& target, const PointCloud& source, const Similarity& initial,
    const ParameterSet& parameters, const JobControl& control, const RegistrationWatch& watch);

}  // namespace vestige
