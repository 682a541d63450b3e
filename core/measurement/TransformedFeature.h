#pragma once

#include "core/geometry/Pose.h"
#include "core/measurement/FittedFeature.h"

namespace vestige {

/// The feature in the frame and unit that `to` leads to.
FittedFeature transformed(const Similarity& to, const FittedFeature& feature);

}  // namespace vestige
