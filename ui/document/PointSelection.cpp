#include "ui/document/PointSelection.h"

#include <algorithm>

#include "ui/document/Document.h"

namespace vestige {
namespace {

PointSet stillThere(const Layer& layer, const PointSet& points) {
    return layer.cleaning ? points.without(layer.cleaning->removed) : points;
}

}  // namespace

PointSelection::PointSelection(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document_, &Document::replaced, this, [this] {
        object_.clear();
        clear();
    });
    connect(&document_, &Document::changed, this, [this] { drop(); });
}

void PointSelection::apply(const Sets& found, Mode mode, CleaningStep step) {
    if (mode == Mode::replace) parts_.clear();
    for (const auto& [id, points] : found) {
        const Layer* layer = document_.state().layer(id);
        const auto loaded = layer ? loadedData(*layer) : nullptr;
        if (!loaded) continue;
        const auto held = parts_.find(id);
        const PointSet before = held == parts_.end() ? PointSet() : *held->second.points;
        PointSet now = mode == Mode::subtract ? before.without(points) : before.unitedWith(points);
        now = stillThere(*layer, now);
        if (now.empty())
            parts_.erase(id);
        else
            parts_[id] = {std::make_shared<const PointSet>(std::move(now)), loaded};
    }
    if (mode == Mode::replace) {
        step_ = std::move(step);
    } else if (step_.how.find(step.how) == std::string::npos) {
        step_.how += (step_.how.empty() ? "" : ", ") + step.how;
        step_.parameters += (step_.parameters.empty() ? "" : "; ") + step.parameters;
    }
    emit changed();
}

void PointSelection::clear() {
    reach_.reset();
    behind_ = 0;
    step_ = {};
    if (parts_.empty()) return;
    parts_.clear();
    emit changed();
}

PointSelection::Sets PointSelection::others() const {
    Sets sets;
    for (const Layer& layer : document_.state().layers) {
        const auto loaded = loadedData(layer);
        if (!loaded || !layer.visible) continue;
        const auto selected = of(layer.id);
        const PointSet taken = selected ? *selected : PointSet();
        sets[layer.id] =
            stillThere(layer, taken.complement(static_cast<std::uint32_t>(loaded->points->size())));
    }
    return sets;
}

std::shared_ptr<const PointSet> PointSelection::of(const std::string& layer) const {
    const auto found = parts_.find(layer);
    return found == parts_.end() ? nullptr : found->second.points;
}

std::size_t PointSelection::size() const {
    std::size_t count = 0;
    for (const auto& [id, part] : parts_) count += part.points->size();
    return count;
}

void PointSelection::setObject(std::string name) {
    if (name == object_) return;
    object_ = std::move(name);
    emit changed();
}

/// What is selected of points that were taken out, or read anew, is no longer.
void PointSelection::drop() {
    bool dropped = false;
    for (auto part = parts_.begin(); part != parts_.end();) {
        const Layer* layer = document_.state().layer(part->first);
        const auto loaded = layer ? loadedData(*layer) : nullptr;
        PointSet left;
        if (loaded && part->second.of.lock() == loaded) left = stillThere(*layer, *part->second.points);
        if (left.size() == part->second.points->size()) {
            ++part;
            continue;
        }
        dropped = true;
        if (left.empty()) {
            part = parts_.erase(part);
        } else {
            part->second.points = std::make_shared<const PointSet>(std::move(left));
            ++part;
        }
    }
    const auto& objects = document_.state().objects;
    const bool gone =
        !object_.empty() && std::none_of(objects.begin(), objects.end(),
                                         [&](const SceneObject& one) { return one.name == object_; });
    if (gone) object_.clear();
    if (dropped || gone) emit changed();
}

}  // namespace vestige
