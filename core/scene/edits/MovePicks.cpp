#include "core/scene/edits/MovePicks.h"

#include <utility>

#include "core/scene/PickFrame.h"
#include "core/scene/edits/Same.h"

namespace vestige {
namespace {

PickedPoint& pointOf(SceneState& scene, const MovedPick& pick) {
    if (pick.place) return scene.measurements[pick.measurement].paths.at(pick.key)[pick.repeat][*pick.place];
    PickedPair& pair = scene.measurements[pick.measurement].picks.at(pick.key)[pick.repeat];
    return pick.second ? pair.b : pair.a;
}

/// A pick with the point of the layer it was made on, in the layer's own frame and unit.
struct AnchoredPick {
    MovedPick pick;
    Eigen::Vector3d inLayer;
    std::optional<FittedFeature> fittedInLayer;
    Similarity sceneFromLayerBefore;
    bool placedBefore = false;
};

/// The points of paths, as the ends of pairs below.
void anchorPaths(const SceneState& scene, std::size_t m, std::vector<AnchoredPick>& anchored) {
    for (const auto& [key, paths] : scene.measurements[m].paths) {
        for (std::size_t r = 0; r < paths.size(); ++r) {
            for (std::size_t i = 0; i < paths[r].size(); ++i) {
                const PickedPoint& point = paths[r][i];
                const Layer* layer = scene.layer(point.layer);
                if (!layer || !(point.inLayerFrame || isPlaced(scene, *layer))) continue;
                const Similarity toScene = sceneFromLayer(*layer);
                auto fitted = sceneFeature(scene, point);
                if (fitted) fitted = moved(*fitted, toScene.inverse());
                anchored.push_back({{m, key, r, false, point, i},
                                    toScene.inverse() * scenePosition(scene, point),
                                    std::move(fitted),
                                    toScene,
                                    isPlaced(scene, *layer)});
            }
        }
    }
}

std::vector<AnchoredPick> anchoredPicks(const SceneState& scene) {
    std::vector<AnchoredPick> anchored;
    for (std::size_t m = 0; m < scene.measurements.size(); ++m) {
        anchorPaths(scene, m, anchored);
        for (const auto& [key, pairs] : scene.measurements[m].picks) {
            for (std::size_t r = 0; r < pairs.size(); ++r) {
                for (const bool second : {false, true}) {
                    const PickedPoint& point = second ? pairs[r].b : pairs[r].a;
                    const Layer* layer = scene.layer(point.layer);
                    if (!layer || !(point.inLayerFrame || isPlaced(scene, *layer))) continue;
                    const Similarity toScene = sceneFromLayer(*layer);
                    auto fitted = sceneFeature(scene, point);
                    if (fitted) fitted = moved(*fitted, toScene.inverse());
                    anchored.push_back({{m, key, r, second, point},
                                        toScene.inverse() * scenePosition(scene, point),
                                        std::move(fitted),
                                        toScene,
                                        isPlaced(scene, *layer)});
                }
            }
        }
    }
    return anchored;
}

}  // namespace

std::vector<MovedPick> changeKeepingPicks(SceneState& scene, const std::function<void(SceneState&)>& change) {
    const std::vector<AnchoredPick> anchored = anchoredPicks(scene);
    change(scene);
    std::vector<MovedPick> rewritten;
    for (const AnchoredPick& anchor : anchored) {
        const Layer* layer = scene.layer(anchor.pick.before.layer);
        if (!layer) continue;
        const bool placed = isPlaced(scene, *layer);
        const Similarity toScene = sceneFromLayer(*layer);
        if (placed == anchor.placedBefore && (!placed || same(toScene, anchor.sceneFromLayerBefore)))
            continue;
        PickedPoint& point = pointOf(scene, anchor.pick);
        point.position = placed ? toScene * anchor.inLayer : anchor.inLayer;
        if (anchor.fittedInLayer)
            point.fitted = placed ? moved(*anchor.fittedInLayer, toScene) : *anchor.fittedInLayer;
        point.inLayerFrame = !placed;
        rewritten.push_back(anchor.pick);
    }
    return rewritten;
}

void restorePicks(SceneState& scene, const std::vector<MovedPick>& moved) {
    for (const MovedPick& pick : moved) pointOf(scene, pick) = pick.before;
}

}  // namespace vestige
