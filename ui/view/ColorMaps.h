#pragma once

#include <array>
#include <cstdint>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

using Rgb = std::array<std::uint8_t, 3>;

/// The colour of `share` (0 to 1, clamped; not a number: 0). Viridis, cividis and plasma from ten published
/// colours each (S. van der Walt and N. Smith, 2015; J. Nunez et al., PLoS ONE 13, 2018), straight lines
/// between them. `even` and `grey` keep clear of the theme's background.
Rgb mapColor(ColorMap map, double share, Theme theme);

/// `color`, darker where it would be lost on the light background.
Rgb onTheme(const Rgb& color, Theme theme);

}  // namespace vestige
