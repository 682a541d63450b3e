#include "core/scene/Cleaning.h"

#include <algorithm>
#include <utility>

#include "core/scene/Scene.h"

namespace vestige {

const std::vector<std::string>& objectKinds() {
    static const std::vector<std::string> kinds{"vehicle", "debris", "vegetation", "ground", "other"};
    return kinds;
}

std::shared_ptr<const LayerData> loadedData(const Layer& layer) {
    if (!layer.data || !layer.data->points || layer.data->isPreview()) return nullptr;
    return layer.data->uncleaned ? layer.data->uncleaned : layer.data;
}

std::uint32_t loadedIndex(const LayerData& data, std::uint32_t point) {
    return data.kept ? (*data.kept)[point] : point;
}

PointSet loadedIndices(const LayerData& data, std::vector<std::uint32_t> points) {
    for (std::uint32_t& point : points) point = loadedIndex(data, point);
    return PointSet::fromSorted(points);
}

bool isCleaned(const LayerData& data, const Cleaning* cleaning) {
    if (!cleaning || cleaning->removed.empty()) return !data.uncleaned;
    if (!data.uncleaned || !data.kept) return false;
    const std::vector<std::uint32_t>& kept = *data.kept;
    const std::size_t loaded = data.uncleaned->points->size();
    if (loaded != cleaning->loadedPoints || kept.size() + cleaning->removed.size() != loaded) return false;
    // `kept` ascends and has the right size: it is the rest where it leaps over each run.
    std::size_t gone = 0;
    for (const auto& [first, last] : cleaning->removed.runs()) {
        const std::size_t place = first - gone;
        if (place > 0 && (place > kept.size() || kept[place - 1] != first - 1)) return false;
        gone += last - first;
        if (place < kept.size() && kept[place] != last) return false;
    }
    return true;
}

std::optional<std::string> cleaningMismatch(const Layer& layer) {
    const auto loaded = loadedData(layer);
    if (!layer.cleaning || !loaded) return std::nullopt;
    const Cleaning& cleaning = *layer.cleaning;
    const std::string what = "the points taken out of layer '" + layer.id + "' ";
    if (loaded->sha256 != cleaning.sha256)
        return what + "belong to another file than " + layer.path.string() + ", expected SHA-256 " +
               cleaning.sha256 + ", found " + loaded->sha256;
    if (loaded->points->size() != cleaning.loadedPoints)
        return what + "belong to another part of " + layer.path.string() + ", expected " +
               std::to_string(cleaning.loadedPoints) + " points, found " +
               std::to_string(loaded->points->size());
    return std::nullopt;
}

bool belongsTo(const SceneObject& object, const Layer& layer) {
    const auto loaded = loadedData(layer);
    return loaded && object.layer == layer.id && object.points && loaded->sha256 == object.sha256 &&
           loaded->points->size() == object.loadedPoints;
}

Result<std::shared_ptr<const Cleaning>> withRemoved(const Layer& layer, const PointSet& points,
                                                    CleaningStep step) {
    const auto loaded = loadedData(layer);
    if (!loaded)
        return fail(ErrorCode::usage, "the layer is not loaded yet", layer.id,
                    "wait until all of its points are read");
    if (const auto mismatch = cleaningMismatch(layer))
        return fail(ErrorCode::usage, *mismatch, layer.id, "take its cleaning back first");
    auto cleaning = std::make_shared<Cleaning>(layer.cleaning ? *layer.cleaning : Cleaning{});
    const std::size_t before = cleaning->removed.size();
    cleaning->removed = cleaning->removed.unitedWith(points);
    if (cleaning->removed.size() == before) return std::shared_ptr<const Cleaning>();
    if (cleaning->removed.size() >= loaded->points->size())
        return fail(ErrorCode::usage, "nothing would be left of the layer", layer.id,
                    "hide the layer, or remove it from the case");
    cleaning->loadedPoints = static_cast<std::uint32_t>(loaded->points->size());
    cleaning->sha256 = loaded->sha256;
    step.points = cleaning->removed.size() - before;
    cleaning->steps.push_back(std::move(step));
    return std::shared_ptr<const Cleaning>(std::move(cleaning));
}

std::string unusedObjectName(const SceneState& scene, const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(scene.objects.begin(), scene.objects.end(),
                           [&](const SceneObject& object) { return object.name == name; });
    };
    std::string name = wanted;
    for (int number = 2; taken(name); ++number) name = wanted + " " + std::to_string(number);
    return name;
}

}  // namespace vestige
