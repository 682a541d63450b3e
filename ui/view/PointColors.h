#pragma once

#include <optional>
#include <vector>

#include "ui/view/ColorScale.h"

namespace vestige {

/// Colours of a layer's points (by index into its cloud) in a description; `scale` is that of
/// colorScales(view), if it has one.
std::vector<std::array<std::uint8_t, 4>> pointColors(const ViewDescription& view, std::size_t layer,
                                                     const std::optional<ColorScale>& scale);

}  // namespace vestige
