#include "ui/actions/reactions/FindParts.h"

#include <limits>

#include "core/filters/CleaningParameters.h"

namespace vestige {
namespace {

std::array<double, 3> sidesOf(const UprightBox& box) {
    return {box.length_m, box.width_m, box.height_m};
}

}  // namespace

Result<PointSelection::Sets> outliersOf(const std::vector<Layer>& layers, const ParameterSet& settings,
                                        const JobControl& control) {
    PointSelection::Sets sets;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const auto count = static_cast<double>(layers.size());
        const auto part = control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        const Layer& layer = layers[i];
        auto found = findOutliers(*layer.data->points, outlierOptions(settings, layer.metresPerUnit()), part);
        if (!found) return fail(found.error());
        sets[layer.id] = loadedIndices(*layer.data, std::move(*found));
    }
    return sets;
}

Result<PointSelection::Sets> groundOf(const Layer& layer, const ParameterSet& settings,
                                      const JobControl& control) {
    const UprightPoints points(*layer.data->points, sceneFromLayer(layer));
    const auto ground = findGround(points, groundOptions(settings), control);
    if (!ground) return fail(ground.error());
    return PointSelection::Sets{{layer.id, loadedIndices(*layer.data, groundPoints(points, *ground))}};
}

Result<std::vector<SceneObject>> objectsOf(const Layer& layer, const ParameterSet& groundSettings,
                                           const ParameterSet& settings, const JobControl& control) {
    const UprightPoints points(*layer.data->points, sceneFromLayer(layer));
    const auto ground = findGround(points, groundOptions(groundSettings), control.sub(0, 0.6));
    if (!ground) return fail(ground.error());
    auto found = findObjects(points, *ground, objectOptions(settings), control.sub(0.6, 1));
    if (!found) return fail(found.error());
    const std::string how = "separated; " + describe(groundSettings) + "; " + describe(settings);
    const auto loaded = loadedData(layer);
    std::vector<SceneObject> objects;
    for (FoundObject& one : *found) {
        SceneObject object;
        object.kind = one.kind;
        object.layer = layer.id;
        object.points = std::make_shared<const PointSet>(loadedIndices(*layer.data, std::move(one.points)));
        object.loadedPoints = static_cast<std::uint32_t>(loaded->points->size());
        object.sha256 = loaded->sha256;
        object.size_m = sidesOf(one.box);
        object.found = how;
        objects.push_back(std::move(object));
    }
    return objects;
}

SceneObject objectFrom(const Layer& layer, const std::shared_ptr<const PointSet>& points, std::string found) {
    const auto loaded = loadedData(layer);
    const UprightPoints upright(*loaded->points, sceneFromLayer(layer));
    std::vector<Eigen::Vector3f> places;
    places.reserve(points->size());
    for (const auto& [first, last] : points->runs())
        for (std::uint32_t i = first; i < last; ++i) places.push_back(upright[i]);
    const UprightBox box = uprightBox(places);
    SceneObject object;
    object.kind = kindOf(box, 0);
    object.layer = layer.id;
    object.points = points;
    object.loadedPoints = static_cast<std::uint32_t>(loaded->points->size());
    object.sha256 = loaded->sha256;
    object.size_m = sidesOf(box);
    object.found = std::move(found);
    return object;
}

BoundingBox boundsOf(const Layer& layer, const PointSet& points) {
    const auto loaded = loadedData(layer);
    const Similarity place = sceneFromLayer(layer);
    BoundingBox box;
    for (const auto& [first, last] : points.runs())
        for (std::uint32_t i = first; i < last; ++i) box.add(place * loaded->points->point(i));
    return box;
}

std::string nameOfKind(const std::string& kind) {
    if (kind == "vehicle") return "Vehicle";
    if (kind == "debris") return "Debris";
    if (kind == "vegetation") return "Pole or plant";
    if (kind == "ground") return "Ground";
    return "Object";
}

}  // namespace vestige
