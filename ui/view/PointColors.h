#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ui/view/ColorScale.h"

namespace vestige {

using Rgba = std::array<std::uint8_t, 4>;

/// The colour of a point, by its index into the cloud; any thread. It holds what it needs of the layer.
using PointPainter = std::function<Rgba(std::size_t point)>;

/// How a layer's points are coloured in a description, with 0 in the last place for those that are hidden;
/// `scale` is that of colorScale(view), if it has one. Ranges of brightness come from a sample of the points,
/// so that this takes milliseconds for any cloud.
PointPainter pointPainter(const ViewDescription& view, std::size_t layer,
                          const std::optional<ColorScale>& scale);

/// The colours of all points.
std::vector<Rgba> pointColors(const ViewDescription& view, std::size_t layer,
                              const std::optional<ColorScale>& scale);

}  // namespace vestige
