#include "core/scene/KindRepeats.h"

#include <algorithm>
#include <cmath>

#include "core/scene/MeasuredScene.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

/// The local spacing where the pick has none of its own: that of the nearest point of the loaded layer.
double spacingAt(const SceneState& scene, const PickedPoint& point) {
    if (point.localSpacing_m) return *point.localSpacing_m;
    const Layer& layer = *scene.layer(point.layer);
    if (!layer.data || !layer.data->octree || layer.data->octree->cloud().empty()) return 0;
    const Octree& octree = *layer.data->octree;
    const Similarity toScene = sceneFromLayer(layer);
    const Eigen::Vector3d inLayer = toScene.inverse() * scenePosition(scene, point);
    std::vector<Octree::Neighbour> found;
    octree.nearest((inLayer - octree.cloud().origin()).cast<float>(), 1, found);
    return found.empty() ? 0 : toScene.scale * octree.localSpacing(found.front().point);
}

/// The RMSE stands in for the covariance of a registration that has none, as for a length.
KindBody bodyOf(const Layer& layer) {
    KindBody body{layer.name.empty() ? layer.id : layer.name, std::nullopt};
    if (!layer.registration) return body;
    if (layer.registration->quality) {
        body.pose = layer.registration->quality->uncertainty;
    } else if (std::isfinite(layer.registration->rmse_m)) {
        body.pose = PoseUncertainty{};
        const double rmse = layer.registration->rmse_m;
        body.pose->covariance.diagonal().head<3>().setConstant(rmse * rmse);
    }
    return body;
}

class Collector {
  public:
    Collector(const SceneState& scene, const Measurement& measurement, bool fitted)
        : scene_(scene), spec_(kindSpec(measurement.kind)), fitted_(fitted) {
        result_.measurement.kind = measurement.kind;
        result_.measurement.settings = measurement.settings;
    }

    void add(const std::vector<PickedPoint>& points) {
        if (points.size() < spec_.fewest || (spec_.most > 0 && points.size() > spec_.most)) {
            ++wrongCount_;
            return;
        }
        if (!inOneFrame(points)) return;
        KindRepeat repeat;
        for (const PickedPoint& point : points) {
            anyFitted_ = anyFitted_ || point.fitted;
            repeat.ends.push_back(kindEnd(scene_, point, fitted_));
            repeat.ends.back().body = bodyNumber(*scene_.layer(point.layer));
        }
        result_.measurement.repeats.push_back(std::move(repeat));
    }

    KindRepeats take() {
        if (fitted_ && !anyFitted_) return {};
        const auto left = [&](std::size_t count, const std::string& why) {
            if (count > 0)
                result_.notes.push_back(std::to_string(count) +
                                        (count == 1 ? " repeat left out: " : " repeats left out: ") + why);
        };
        left(wrongCount_, "this kind needs " + std::to_string(spec_.fewest) +
                              (spec_.most == spec_.fewest ? " points" : " points or more"));
        left(absent_, "picked on a layer which this case does not have");
        left(apart_, "their points lie on layers that are not registered to each other");
        return std::move(result_);
    }

  private:
    /// All points in the target's frame, or all on one layer and given in one frame.
    bool inOneFrame(const std::vector<PickedPoint>& points) {
        bool placed = true, together = true;
        for (const PickedPoint& point : points) {
            if (!scene_.layer(point.layer)) {
                ++absent_;
                return false;
            }
            placed = placed && inTargetFrame(scene_, point);
            together = together && point.layer == points.front().layer &&
                       inTargetFrame(scene_, point) == inTargetFrame(scene_, points.front());
        }
        if (!placed && !together) ++apart_;
        return placed || together;
    }

    std::size_t bodyNumber(const Layer& layer) {
        const auto found = std::find(result_.layers.begin(), result_.layers.end(), layer.id);
        if (found != result_.layers.end()) return static_cast<std::size_t>(found - result_.layers.begin());
        result_.layers.push_back(layer.id);
        result_.measurement.bodies.push_back(bodyOf(layer));
        return result_.layers.size() - 1;
    }

    const SceneState& scene_;
    const KindSpec& spec_;
    bool fitted_;
    bool anyFitted_ = false;
    std::size_t wrongCount_ = 0, absent_ = 0, apart_ = 0;
    KindRepeats result_;
};

/// Keys of a map of repeats in the order of the layers, others behind them.
template <class Map>
std::vector<std::string> orderedKeys(const SceneState& scene, const Map& repeats) {
    std::vector<std::string> keys;
    for (const Layer& layer : scene.layers)
        if (repeats.contains(layer.id)) keys.push_back(layer.id);
    for (const auto& [key, items] : repeats)
        if (!scene.layer(key)) keys.push_back(key);
    return keys;
}

}  // namespace

std::string methodOfRepeat(const SceneState& scene, const std::string& key, const PickedPoint& first) {
    if (const Layer* layer = scene.layer(key)) return layer->method;
    for (const Layer& layer : scene.layers)
        if (layer.method == key) return key;
    const Layer* layer = scene.layer(first.layer);
    return layer ? layer->method : std::string();
}

KindEnd kindEnd(const SceneState& scene, const PickedPoint& point, bool fitted) {
    KindEnd end;
    end.position = scenePosition(scene, point);
    end.noise_m = sensorNoise_m(scene.layer(point.layer)->role);
    if (!fitted || !point.fitted) {
        end.spacing_m = spacingAt(scene, point);
        return end;
    }
    const Similarity toScene = sceneFromPick(scene, point);
    const Eigen::Matrix3d turn = toScene.pose.linear();
    end.position = toScene * point.fitted->position;
    end.covariance = toScene.scale * toScene.scale * turn * point.fitted->covariance * turn.transpose();
    if (point.fitted->mode == SnapMode::plane && point.fitted->axis.norm() > 0.5)
        end.normal = (turn * point.fitted->axis).normalized();
    return end;
}

bool hasFitted(const SceneState& scene, const Measurement& measurement, const std::string& method) {
    for (const auto& [key, pairs] : measurement.picks)
        for (const PickedPair& pair : pairs)
            if ((pair.a.fitted || pair.b.fitted) && methodOfRepeat(scene, key, pair.a) == method) return true;
    if (kindSpec(measurement.kind).isPair()) return false;
    for (const auto& [key, paths] : measurement.paths)
        for (const PickedPath& path : paths)
            if (std::any_of(path.begin(), path.end(),
                            [](const auto& point) { return point.fitted.has_value(); }) &&
                methodOfRepeat(scene, key, path.front()) == method)
                return true;
    return false;
}

KindRepeats kindRepeats(const SceneState& scene, const Measurement& measurement, const std::string& method,
                        bool fitted) {
    Collector collector(scene, measurement, fitted);
    for (const std::string& key : orderedKeys(scene, measurement.picks))
        for (const PickedPair& pair : measurement.picks.at(key))
            if (methodOfRepeat(scene, key, pair.a) == method) collector.add({pair.a, pair.b});
    // Kinds of two ends are picked as pairs; paths may be left of another kind.
    if (kindSpec(measurement.kind).isPair()) return collector.take();
    for (const std::string& key : orderedKeys(scene, measurement.paths))
        for (const PickedPath& path : measurement.paths.at(key))
            if (!path.empty() && methodOfRepeat(scene, key, path.front()) == method) collector.add(path);
    return collector.take();
}

}  // namespace vestige
