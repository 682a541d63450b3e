#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "ui/view/ColorMaps.h"

namespace vestige {

/// The meaning of a point class by the LAS 1.4 specification (ASPRS, R15, table 17).
QString className(std::uint8_t code);
Rgb classColor(std::uint8_t code, Theme theme);

/// The classes of the points that are drawn, ascending. Of more than four million points of a layer an even
/// part is looked at.
std::vector<std::uint8_t> classesShown(const ViewDescription& view);

}  // namespace vestige
