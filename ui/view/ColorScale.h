#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

using Rgb = std::array<std::uint8_t, 3>;

/// The colours of a value from `low` to `high`, drawn as a bar in the legend.
struct ColorScale {
    std::string title;  ///< "Height", "Distance to target"
    std::string unit;
    double low = 0;
    double high = 1;
    double displayFactor = 1;  ///< shown number = value times this (1000 for mm)
    bool warm = false;
    Rgb at(double value) const;
};

/// `share` 0 to 1, clamped. Even steps of lightness and hue in Oklab (B. Ottosson, 2020), so that equal steps
/// of the value look equal; its dark end still stands out from the background.
Rgb heightColor(double share);
/// The same for errors: calm blue-grey for none, through orange, to red.
Rgb errorColor(double share);

/// What the colours of a description mean; nothing for rgb, source, intensity and the overlay `registration`.
/// Heights reach from the 1 % to the 99 % value of the visible layers, so that stray points do not flatten
/// the colours; distances from 0 to a round number over their 90 % value.
std::optional<ColorScale> colorScale(const ViewDescription& view);

/// What the others are registered to: the layer that says so, else the first.
std::size_t targetLayer(const ViewDescription& view);

/// Tint that a layer has in this description: its own, or that of source and target in the overlay
/// `registration`.
Rgb layerTint(const ViewDescription& view, std::size_t layer);

}  // namespace vestige
