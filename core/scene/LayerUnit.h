#pragma once

#include <optional>

#include "core/scene/Layer.h"

namespace vestige {

/// Metres per unit of a loaded layer's file, where the file says it; any length, not only our units'.
std::optional<double> fileMetresPerUnit(const Layer& layer);

/// Gives the layer the unit that a registration was made with, where it has none and its file does not say
/// that very length: Layer::metresPerUnit() is the same before and after for a file taken at its word.
void noteUnit(Layer& layer, double metresPerUnit);

}  // namespace vestige
