#pragma once

#include <vector>

#include "core/registration/ndt/TargetLevels.h"

namespace vestige {

/// Whether a pose that the whole cells ended at explains too little of the source to be believed.
bool explainsTooLittle(const TargetLevels& levels, const CentredSource& source, const Pose& pose);

/// Poses to start from when the first pose led nowhere: of a fan of turns up to 45 degrees and shifts up to
/// 1.25 v0 round `start`, those that the cells of v0 score best after a descent at v0, the best first.
/// The poses map `source`.
std::vector<Pose> startFan(const TargetLevels& levels, const CentredSource& source, const Pose& start,
                           const TrustRegionOptions& limits);

}  // namespace vestige
