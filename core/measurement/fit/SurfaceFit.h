#pragma once

#include <optional>

#include "core/measurement/fit/Neighbourhood.h"
#include "core/measurement/fit/PointFits.h"

namespace vestige {

/// Where the line of sight through the seed meets what is seen there: the near end of the points beside it,
/// their noise along the view taken out (see meanUpperEnd). Something small before something larger has
/// echoes anywhere between the two, and its near end is its own. Its place across the view is the line of
/// sight itself. Nothing with fewer than 8 points beside it.
std::optional<PlaceFit> surfaceAtSeed(const Neighbourhood& near);

}  // namespace vestige
