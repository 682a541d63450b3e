#include "core/scene/LayerUnit.h"

namespace vestige {

std::optional<double> fileMetresPerUnit(const Layer& layer) {
    return layer.data ? layer.data->info.metresPerUnit : std::nullopt;
}

void noteUnit(Layer& layer, double metresPerUnit) {
    if (layer.unit) return;
    const bool asItsFileSays = fileMetresPerUnit(layer) == metresPerUnit;
    if (!asItsFileSays || lengthUnitOf(metresPerUnit)) layer.unit = nearestLengthUnit(metresPerUnit);
}

}  // namespace vestige
