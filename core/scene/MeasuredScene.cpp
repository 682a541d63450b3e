#include "core/scene/MeasuredScene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/Units.h"
#include "core/measurement/fit/FittedLength.h"
#include "core/scene/KindRepeats.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

double square(double x) {
    return x * x;
}

std::vector<std::string> methodsOf(const SceneState& scene) {
    std::vector<std::string> methods;
    for (const Layer& layer : scene.layers)
        if (std::find(methods.begin(), methods.end(), layer.method) == methods.end())
            methods.push_back(layer.method);
    return methods;
}

/// The method that picks under `key` count for: of the layer of that id, else the method of that name, else
/// of the layer of the first end. Empty when the scene has none of them.
std::string methodOf(const SceneState& scene, const std::string& key, const PickedPair& pair) {
    if (const Layer* layer = scene.layer(key)) return layer->method;
    for (const Layer& layer : scene.layers)
        if (layer.method == key) return key;
    const Layer* layer = scene.layer(pair.a.layer);
    return layer ? layer->method : std::string();
}

/// Keys of the picks in the order of the layers, others behind them.
std::vector<std::string> orderedKeys(const SceneState& scene, const Measurement& measurement) {
    std::vector<std::string> keys;
    for (const Layer& layer : scene.layers)
        if (measurement.picks.contains(layer.id)) keys.push_back(layer.id);
    for (const auto& [key, pairs] : measurement.picks)
        if (!scene.layer(key)) keys.push_back(key);
    return keys;
}

/// The local spacing where the pick has none of its own: that of the nearest point of the loaded layer.
double localSpacing_m(const SceneState& scene, const PickedPoint& point) {
    if (point.localSpacing_m) return *point.localSpacing_m;
    const Layer& layer = *scene.layer(point.layer);
    // As loaded: what cleaning takes away round a pick makes it no less certain.
    const LayerData* data = layer.data.get();
    if (data && data->uncleaned) data = data->uncleaned.get();
    if (!data || !data->octree || data->octree->cloud().empty()) return 0;
    const Octree& octree = *data->octree;
    const Similarity sceneFromHere = sceneFromLayer(layer);
    const Eigen::Vector3d inLayer = sceneFromHere.inverse() * scenePosition(scene, point);
    std::vector<Octree::Neighbour> found;
    octree.nearest((inLayer - octree.cloud().origin()).cast<float>(), 1, found);
    return found.empty() ? 0 : sceneFromHere.scale * octree.localSpacing(found.front().point);
}

/// Squared share of a layer's pose in a length from one of its points, along the length: from the pose's
/// covariance at that point. The RMSE stands in for the covariance of a registration that has none (of an
/// older case file): it holds the sensors' noise too, so it rather overstates the pose's part.
double squaredPoseShare(const Layer& layer, const Eigen::Vector3d& point, const Eigen::Vector3d& along) {
    if (!layer.registration) return 0;
    if (layer.registration->quality)
        return along.dot(layer.registration->quality->uncertainty.at(point) * along);
    return std::isfinite(layer.registration->rmse_m) ? square(layer.registration->rmse_m) : 0;
}

/// What the pairs of one object and method add up to.
struct Repeats {
    std::vector<double> lengths_m;
    std::vector<std::string> layers;
    std::vector<std::string> absentLayers;
    std::size_t withoutCommonFrame = 0;
    std::size_t withoutFeature = 0;
    Eigen::Vector3d sumA = Eigen::Vector3d::Zero();
    Eigen::Vector3d sumB = Eigen::Vector3d::Zero();
    double beam_m = 0;
    // Sums over the repeats; their means go into the statistic.
    double noiseA = 0, noiseB = 0, spacingA = 0, spacingB = 0, pose = 0;

    /// `fitted`: by the features round the picks; a pair that has none at either end counts by its points.
    void add(const SceneState& scene, const PickedPair& pair, bool fitted) {
        bool complete = true;
        for (const PickedPoint* end : {&pair.a, &pair.b}) {
            const bool present = scene.layer(end->layer) != nullptr;
            remember(present ? layers : absentLayers, end->layer);
            complete = complete && present;
        }
        if (!complete) return;
        const Layer& layerA = *scene.layer(pair.a.layer);
        const Layer& layerB = *scene.layer(pair.b.layer);
        // Ends on one layer need no common frame, but both must be given in the same one.
        const bool sameLayer = layerA.id == layerB.id;
        const bool comparable = (inTargetFrame(scene, pair.a) && inTargetFrame(scene, pair.b)) ||
                                (sameLayer && inTargetFrame(scene, pair.a) == inTargetFrame(scene, pair.b));
        if (!comparable) {
            ++withoutCommonFrame;
            return;
        }
        EndPair ends{scenePosition(scene, pair.a), scenePosition(scene, pair.b)};
        if (fitted && (pair.a.fitted || pair.b.fitted)) {
            const FittedEnd from = fittedEnd(scene, pair.a);
            const FittedEnd to = fittedEnd(scene, pair.b);
            const FittedLength length = fittedLength(from, to);
            lengths_m.push_back(length.length_m);
            // Repeats fit to the same points: their error stays, however many there are.
            noiseA += length.variance_m2;
            ends = {length.a, length.b};
            const Eigen::Vector3d way = (ends.b - ends.a).normalized();
            spacingA += driftShare(layerA, from, way);
            spacingB += driftShare(layerB, to, way);
        } else {
            withoutFeature += fitted ? 1 : 0;
            lengths_m.push_back(ends.length_m());
            noiseA += square(sensorNoise_m(layerA.role));
            noiseB += square(sensorNoise_m(layerB.role));
            spacingA += square(localSpacing_m(scene, pair.a));
            spacingB += square(localSpacing_m(scene, pair.b));
        }
        sumA += ends.a;
        sumB += ends.b;
        beam_m = std::max({beam_m, sensorBeam_m(layerA.role), sensorBeam_m(layerB.role)});
        if (sameLayer) return;
        const Eigen::Vector3d along = (ends.b - ends.a).normalized();
        pose += squaredPoseShare(layerA, ends.a, along) + squaredPoseShare(layerB, ends.b, along);
    }

    std::optional<LengthStatistic> statistic() const {
        if (lengths_m.empty()) return std::nullopt;
        const auto rms = [n = static_cast<double>(lengths_m.size())](double sum) {
            return std::sqrt(sum / n);
        };
        return lengthStatistic(lengths_m, {rms(noiseA), rms(spacingA)}, {rms(noiseB), rms(spacingB)},
                               rms(pose));
    }

    /// A plane across the length is seen from its own side of the site alone, so at other times than the
    /// plane at the other end, between which the navigation has drifted; an edge is seen when its counterpart
    /// is. Twelve times the variance, as a spacing.
    static double driftShare(const Layer& layer, const FittedEnd& end, const Eigen::Vector3d& way) {
        constexpr double kAcross = 0.7;
        if (end.feature.mode != SnapMode::plane || std::abs(end.feature.axis.dot(way)) < kAcross) return 0;
        return 12 * square(sensorDrift_m(layer.role));
    }

    /// What was fitted at an end; the point itself, with the sensor's noise, where nothing was.
    static FittedEnd fittedEnd(const SceneState& scene, const PickedPoint& point) {
        FittedEnd end{scenePosition(scene, point), {}};
        if (auto feature = sceneFeature(scene, point)) {
            end.feature = std::move(*feature);
            return end;
        }
        end.feature.mode = SnapMode::point;
        end.feature.position = end.pick;
        const double u2 =
            square(EndUncertainty{sensorNoise_m(scene.layer(point.layer)->role), localSpacing_m(scene, point)}
                       .standard_m());
        end.feature.covariance = u2 * Eigen::Matrix3d::Identity();
        return end;
    }

    static void remember(std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
};

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
}

std::string noteOf(const Repeats& repeats) {
    std::string note;
    const auto add = [&](const std::string& sentence) { note += (note.empty() ? "" : "; ") + sentence; };
    if (repeats.lengths_m.empty()) add("not measured with this method");
    if (!repeats.absentLayers.empty())
        add("picked on " + listed(repeats.absentLayers) + ", which this case does not have");
    if (repeats.withoutCommonFrame > 0)
        add(std::to_string(repeats.withoutCommonFrame) +
            " repeats left out: their ends lie on layers that are not registered to each other");
    if (repeats.withoutFeature > 0)
        add(std::to_string(repeats.withoutFeature) +
            " repeats by the points themselves: no feature was fitted at either end");
    if (repeats.lengths_m.size() == 1) add("one repeat only, so no uncertainty");
    return note;
}

MeasuredLength measured(const SceneState& scene, const Measurement& measurement, const std::string& method,
                        bool fitted) {
    constexpr double kSpots = 3;
    constexpr double kTapeResolution_m = 0.01;
    Repeats repeats;
    for (const auto& key : orderedKeys(scene, measurement)) {
        for (const auto& pair : measurement.picks.at(key)) {
            const std::string countsFor = methodOf(scene, key, pair);
            // Nothing in this case tells the method of picks on layers it lacks: every row without a length
            // says so.
            if (countsFor == method || countsFor.empty()) repeats.add(scene, pair, fitted);
        }
    }
    MeasuredLength row;
    row.object = measurement.object;
    row.method = fitted ? fittedMethod(method) : method;
    row.fitted = fitted;
    row.tape_m = measurement.tape_m;
    row.tapeUncertainty_m = tapeUncertainty(measurement.tapeResolution_m.value_or(kTapeResolution_m));
    row.length = repeats.statistic();
    if (row.length && row.tape_m) row.re = relativeError(row.length->mean_m, *row.tape_m);
    row.layers = repeats.layers;
    row.note = noteOf(repeats);
    if (!row.length) return row;
    row.a = repeats.sumA / static_cast<double>(repeats.lengths_m.size());
    row.b = repeats.sumB / static_cast<double>(repeats.lengths_m.size());
    row.small = row.tape_m.value_or(row.length->mean_m) < kSpots * repeats.beam_m;
    return row;
}

/// True when some pick of a length that counts for the method has a feature fitted round it.
bool hasFittedPicks(const SceneState& scene, const std::string& method) {
    return std::any_of(scene.measurements.begin(), scene.measurements.end(), [&](const Measurement& each) {
        return kindSpec(each.kind).isLength && hasFitted(scene, each, method);
    });
}

/// The row of a length other than a distance; nothing for other kinds. By features, repeats and picks without
/// one count by the points themselves, as those of a distance do.
std::optional<MeasuredLength> kindRow(const SceneState& scene, const MeasuredScene& result,
                                      const Measurement& measurement, const std::string& method,
                                      bool fitted) {
    const bool any = fitted && hasFitted(scene, measurement, method);
    auto row = lengthOfKind(result.kinds, measurement, any ? fittedMethod(method) : method);
    if (!row || !fitted) return row;
    row->method = fittedMethod(method);
    row->fitted = true;
    if (!any && row->length)
        row->note += (row->note.empty() ? "" : "; ") + std::to_string(row->length->repeats_m.size()) +
                     " repeats by the points themselves: no feature was fitted at either end";
    if (!kindSpec(measurement.kind).isPair()) return row;
    const auto& repeats = kindRepeats(scene, measurement, method, any).measurement.repeats;
    for (const KindRepeat& repeat : repeats) {
        row->a += repeat.ends[0].position / static_cast<double>(repeats.size());
        row->b += repeat.ends[1].position / static_cast<double>(repeats.size());
    }
    return row;
}

/// The accuracy of one method from its rows, and its exclusions back into them.
MethodAccuracy accuracyOf(const std::string& method, std::vector<MeasuredLength>& lengths) {
    std::vector<AccuracyObject> objects;
    std::vector<MeasuredLength*> rows;
    for (MeasuredLength& row : lengths) {
        if (row.method != method || !row.tape_m) continue;
        std::optional<double> mean;
        if (row.length) mean = row.length->mean_m;
        objects.push_back({row.object, *row.tape_m, mean, {}, false, row.small});
        rows.push_back(&row);
    }
    MethodAccuracy accuracy = methodAccuracy(method, objects);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i]->excluded = accuracy.objects[i].excluded;
    return accuracy;
}

}  // namespace

MeasuredScene measureScene(const SceneState& scene) {
    MeasuredScene result;
    struct Way {
        std::string method;
        bool fitted;
    };
    std::vector<Way> ways;
    const std::vector<std::string> methods = methodsOf(scene);
    for (const std::string& method : methods) {
        ways.push_back({method, false});
        if (hasFittedPicks(scene, method)) ways.push_back({method, true});
    }
    result.kinds = measureKinds(scene, methods);
    for (const Measurement& measurement : scene.measurements)
        for (const Way& way : ways) {
            if (measurement.kind == MeasurementKind::distance)
                result.lengths.push_back(measured(scene, measurement, way.method, way.fitted));
            else if (auto row = kindRow(scene, result, measurement, way.method, way.fitted))
                result.lengths.push_back(std::move(*row));
        }
    for (const Way& way : ways)
        result.accuracy.push_back(
            accuracyOf(way.fitted ? fittedMethod(way.method) : way.method, result.lengths));
    result.checks = distanceChecks(scene, result.lengths);
    return result;
}

std::string fittedMethod(const std::string& method) {
    return method + " fitted";
}

bool pointsErrApart(LayerRole role) {
    return role != LayerRole::photogrammetry;
}

SensorSpot sensorSpot(LayerRole role) {
    return role == LayerRole::aerial ? SensorSpot{radians(0.28), radians(0.03)} : SensorSpot{};
}

double sensorDrift_m(LayerRole role) {
    return role == LayerRole::aerial ? 0.01 : 0;
}

double sensorBeam_m(LayerRole role) {
    constexpr double kRange_m = 15;
    return kRange_m * sensorSpot(role).upright_rad;
}

double sensorNoise_m(LayerRole role) {
    switch (role) {
        case LayerRole::aerial:
            return 0.03;
        case LayerRole::handheld:
            return 0.0001;
        case LayerRole::photogrammetry:
            return 0.05;
    }
    return 0;
}

}  // namespace vestige
