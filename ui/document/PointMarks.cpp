#include "ui/document/PointMarks.h"

#include "ui/document/Document.h"
#include "ui/document/PointSelection.h"

namespace vestige {

void PointMarks::apply(ViewDescription& view) {
    const SceneState& scene = document_.state();
    const auto forget = [&](std::map<std::string, Known>& known) {
        std::erase_if(known, [&](const auto& one) { return !scene.layer(one.first); });
    };
    forget(selected_);
    forget(hidden_);
    for (ViewLayer& shown : view.layers) {
        const Layer* layer = scene.layer(shown.id);
        if (!layer || !layer->data) continue;
        const auto selected = selection_.of(shown.id);
        shown.selected = flagsOf(selected_[shown.id], layer->data, selected ? Sets{selected} : Sets{});
        shown.hidden = flagsOf(hidden_[shown.id], layer->data, hiddenSets(scene, *layer));
    }
}

PointFlags PointMarks::flagsOf(Known& known, const std::shared_ptr<const LayerData>& data, Sets sets) {
    if (sets.empty()) {
        known = {};
        return nullptr;
    }
    if (known.data == data && known.sets == sets) return known.flags;
    std::vector<const PointSet*> bare;
    for (const auto& set : sets) bare.push_back(set.get());
    known = {data, std::move(sets), pointFlags(*data, bare)};
    return known.flags;
}

}  // namespace vestige
