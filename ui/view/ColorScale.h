#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/view/ColorMaps.h"

namespace vestige {

/// The colours of a value from `low` to `high`, drawn as a bar in the legend.
struct ColorScale {
    std::string title;  ///< "Height", "Distance to the target's surface"
    std::string unit;
    double low = 0;
    double high = 1;
    double displayFactor = 1;  ///< shown number = value times this (1000 for mm)
    std::optional<double>
        noise;  ///< of signed distances: their spread, 1 sigma; the colours run from -high to high
    Theme theme = Theme::dark;
    bool typed = false;  ///< signed distances: the reach is not from their spread
    ColorMap map = ColorMap::even;
    double power = 1;  ///< of the share, before it becomes a colour: 0.5 tells dark values apart
    std::vector<std::uint8_t> classes{};  ///< in the place of a bar: the point classes that are drawn
    Rgb at(double value) const;
};

/// `share` 0 to 1, clamped. Even steps of lightness and hue in Oklab (B. Ottosson, 2020), so that equal steps
/// of the value look equal; both ends stand out from the background.
Rgb heightColor(double share, Theme theme = Theme::dark);
/// `share` -1 to 1, clamped: blue below zero, grey at zero, orange above; told apart in every common form of
/// colour blindness, and by lightness alone from the middle outwards.
Rgb differenceColor(double share, Theme theme = Theme::dark);
/// A point with nothing of the target to compare with.
Rgb uncomparedColor(Theme theme);
/// What is only there to show where the rest is.
Rgb neutralColor(Theme theme);

/// Of points that are selected: a magenta that no scale and no tint comes near.
Rgb selectionColor(Theme theme);

/// What the colours of a description mean; nothing for rgb, source, intensity and the overlay `registration`.
/// Heights reach from the 1 % to the 99 % value of the visible layers, so that stray points do not flatten
/// the colours; signed distances to a round number over 3 times their spread round the median (1.4826 times
/// the median deviation), so that the noise stays pale and what exceeds it, a shift of the whole layer too,
/// shows.
std::optional<ColorScale> colorScale(const ViewDescription& view);

/// What the others are registered to: the layer that says so; the number of layers where it is not shown.
std::size_t targetLayer(const ViewDescription& view);

/// Tint that a layer has in this description: its own, or that of source and target in the overlay
/// `registration`.
Rgb layerTint(const ViewDescription& view, std::size_t layer);

}  // namespace vestige
