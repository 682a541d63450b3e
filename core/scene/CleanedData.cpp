#include "core/scene/CleanedData.h"

#include <algorithm>
#include <limits>

#include "core/geometry/Selected.h"
#include "core/scene/Scene.h"

namespace vestige {
namespace {

constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();

std::vector<Triangle> trianglesLeft(const std::vector<Triangle>& triangles, std::size_t loaded,
                                    const std::vector<std::uint32_t>& kept) {
    if (triangles.empty()) return {};
    std::vector<std::uint32_t> places(loaded, kGone);
    for (std::uint32_t i = 0; i < kept.size(); ++i) places[kept[i]] = i;
    std::vector<Triangle> left;
    for (const Triangle& corners : triangles) {
        const Triangle moved{places[corners[0]], places[corners[1]], places[corners[2]]};
        if (std::find(moved.begin(), moved.end(), kGone) == moved.end()) left.push_back(moved);
    }
    return left;
}

}  // namespace

Result<std::shared_ptr<const LayerData>> cleanedData(const std::shared_ptr<const LayerData>& loaded,
                                                     const Cleaning& cleaning, const JobControl& control) {
    return guarded("cleaning", [&]() -> Result<std::shared_ptr<const LayerData>> {
        const auto step = [&](double share, const char* what) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            control.progress(share, what);
        };
        step(0, "taking points out");
        auto data = std::make_shared<LayerData>();
        data->info = loaded->info;
        data->sha256 = loaded->sha256;
        data->companionSha256 = loaded->companionSha256;
        data->stamp = loaded->stamp;
        data->uncleaned = loaded;
        data->kept = std::make_shared<const std::vector<std::uint32_t>>(
            cleaning.removed.complement(static_cast<std::uint32_t>(loaded->points->size())).indices());
        data->geometry = std::make_shared<const TriangleMesh>(
            TriangleMesh{loaded->points->select(*data->kept),
                         trianglesLeft(loaded->geometry->triangles, loaded->points->size(), *data->kept)});
        data->points = std::shared_ptr<const PointCloud>(data->geometry, &data->geometry->vertices);
        step(0.3, "index of what is left");
        data->octree = std::make_shared<const Octree>(data->points);
        step(1, "index of what is left");
        return std::shared_ptr<const LayerData>(data);
    });
}

Status applyCleaning(Layer& layer, const JobControl& control) {
    const auto loaded = loadedData(layer);
    if (!loaded || isCleaned(*layer.data, layer.cleaning.get())) return {};
    if (!layer.cleaning) {
        layer.data = loaded;
        return {};
    }
    if (const auto mismatch = cleaningMismatch(layer))
        return fail(ErrorCode::input, *mismatch, layer.path.string(),
                    "clean the layer anew, or take \"cleaning\" out of the case");
    auto cleaned = cleanedData(loaded, *layer.cleaning, control);
    if (!cleaned) return fail(cleaned.error());
    layer.data = std::move(*cleaned);
    return {};
}

Status applyCleaning(SceneState& scene, const JobControl& control) {
    for (Layer& layer : scene.layers)
        if (const Status applied = applyCleaning(layer, control); !applied) return applied;
    return {};
}

}  // namespace vestige
