#pragma once

#include <string>

#include "core/geometry/PoseUncertainty.h"

namespace vestige {

/// What a small motion (t, r w) looks like, for people: "slides level roughly east-west (84° from the y
/// axis)", "moves up and down", "turns about the vertical axis", "tilts about a level axis ...". East is x,
/// north y, up z of the target.
std::string motionWords(const Vector6d& motion);

}  // namespace vestige
