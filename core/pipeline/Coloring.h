#pragma once

#include <optional>
#include <string_view>

namespace vestige {

/// Colours of a value that rises, each from dark to bright in steps that look even. `even` is Vestige's own;
/// the others are known by their names.
enum class ColorMap { even, viridis, cividis, plasma, grey };
std::string_view name(ColorMap map);
std::optional<ColorMap> colorMapFromName(std::string_view name);

/// Where a scale's colours begin and end.
struct ColorRange {
    double cut = 0.01;          ///< share of the values left out at either end, 0 to 0.4
    std::optional<double> low;  ///< typed, in the value's own unit; goes before the share
    std::optional<double> high;
    friend bool operator==(const ColorRange&, const ColorRange&) = default;
};

/// How values become colours.
struct Coloring {
    ColorMap map = ColorMap::even;       ///< of heights
    ColorRange height_m{};               ///< scene, metres
    ColorRange intensity{0.02, {}, {}};  ///< as in the file
    std::optional<double> reach_m;  ///< signed distances run from -reach to reach; nothing: from their spread
    friend bool operator==(const Coloring&, const Coloring&) = default;
};

}  // namespace vestige
