#include "core/scene/KindEdits.h"
#include "core/scene/edits/SwapEdit.h"

namespace vestige {

std::unique_ptr<SceneEdit> movePathPoint(std::string object, std::string layer, std::size_t repeat,
                                         std::size_t place, PickedPoint point) {
    std::string description = "move pick " + object + ", repeat " + std::to_string(repeat + 1);
    const auto find = [object = std::move(object), layer = std::move(layer), repeat,
                       place](SceneState& scene) -> PickedPoint* {
        Measurement* held = scene.measurement(object);
        if (!held) return nullptr;
        const auto found = held->paths.find(layer);
        if (found == held->paths.end() || repeat >= found->second.size()) return nullptr;
        PickedPath& path = found->second[repeat];
        return place < path.size() ? &path[place] : nullptr;
    };
    return std::make_unique<SwapEdit<PickedPoint>>(std::move(description), find, std::move(point));
}

}  // namespace vestige
