#pragma once

#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/registration/RegistrationQuality.h"

namespace vestige {

/// The ways to move that the data leave free, as arrows through the source's middle in the scene's frame,
/// metres: a slide as a straight line as long as the source on either side, a turn as an arc at its RMS
/// radius round the axis. Of a motion that does both, what moves the source more. Labels: the direction's
/// words.
std::vector<ViewArrow> freeDirectionArrows(const RegistrationQuality& quality);

}  // namespace vestige
