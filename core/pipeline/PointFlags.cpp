#include "core/pipeline/PointFlags.h"

#include <algorithm>

#include "core/scene/Cleaning.h"

namespace vestige {

PointFlags pointFlags(const LayerData& data, std::span<const PointSet* const> sets) {
    if (sets.empty() || !data.points) return nullptr;
    auto flags = std::make_shared<std::vector<std::uint8_t>>(data.points->size(), 0);
    bool any = false;
    for (const PointSet* set : sets) {
        auto at = data.kept ? data.kept->begin() : std::vector<std::uint32_t>::const_iterator();
        for (const auto& [first, last] : set->runs()) {
            std::size_t begin = first;
            std::size_t end = last;
            if (data.kept) {
                at = std::lower_bound(at, data.kept->end(), first);
                begin = static_cast<std::size_t>(at - data.kept->begin());
                at = std::lower_bound(at, data.kept->end(), last);
                end = static_cast<std::size_t>(at - data.kept->begin());
            }
            end = std::min(end, flags->size());
            if (begin >= end) continue;
            any = true;
            std::fill(flags->begin() + static_cast<std::ptrdiff_t>(begin),
                      flags->begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t{1});
        }
    }
    return any ? flags : nullptr;
}

std::vector<std::shared_ptr<const PointSet>> hiddenSets(const SceneState& scene, const Layer& layer) {
    std::vector<std::shared_ptr<const PointSet>> sets;
    if (!layer.data || layer.data->isPreview()) return sets;
    const bool pending =
        layer.cleaning && !cleaningMismatch(layer) && !isCleaned(*layer.data, layer.cleaning.get());
    if (pending) sets.push_back(std::shared_ptr<const PointSet>(layer.cleaning, &layer.cleaning->removed));
    for (const SceneObject& object : scene.objects)
        if (!object.visible && belongsTo(object, layer)) sets.push_back(object.points);
    return sets;
}

}  // namespace vestige
