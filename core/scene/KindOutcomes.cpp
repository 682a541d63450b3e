#include "core/scene/KindOutcomes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>

#include "core/scene/CloudKinds.h"
#include "core/scene/CloudNear.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

constexpr std::size_t kRemembered = 256;

double marginOf(MeasurementKind kind, const std::map<std::string, double>& settings) {
    const auto found = settings.find("half_width_m");
    if (found != settings.end()) return found->second;
    return kind == MeasurementKind::profile ? ParameterSet(*kindSpec(kind).parameters).real("half_width_m")
                                            : 0;
}

/// Every number and every cloud that an outcome depends on.
struct Key {
    std::vector<double> numbers;
    std::vector<std::string> words;
    std::vector<std::weak_ptr<const LayerData>> clouds;

    friend bool operator==(const Key& a, const Key& b) {
        return a.numbers == b.numbers && a.words == b.words && a.clouds.size() == b.clouds.size() &&
               std::equal(a.clouds.begin(), a.clouds.end(), b.clouds.begin(),
                          [](const auto& one, const auto& other) {
                              return !one.owner_before(other) && !other.owner_before(one);
                          });
    }
};

template <class Matrix>
void append(std::vector<double>& numbers, const Matrix& matrix) {
    numbers.insert(numbers.end(), matrix.data(), matrix.data() + matrix.size());
}

/// The scan that a volume is counted from; null where that is a plane, or the scan has no place.
const Layer* baseOf(const SceneState& scene, const KindMeasurement& measurement) {
    const auto found = measurement.settings.find("base_scan");
    if (found == measurement.settings.end() || found->second < 1) return nullptr;
    const auto place = static_cast<std::size_t>(found->second) - 1;
    if (place >= scene.layers.size() || !isPlaced(scene, scene.layers[place])) return nullptr;
    return &scene.layers[place];
}

/// Squared standard uncertainty of a layer's height at a place.
double heightVariance(const Layer& layer, const Eigen::Vector3d& point) {
    if (!layer.registration) return 0;
    if (layer.registration->quality) return layer.registration->quality->uncertainty.at(point)(2, 2);
    const double rmse = layer.registration->rmse_m;
    return std::isfinite(rmse) ? rmse * rmse : 0;
}

Key keyOf(const SceneState& scene, const KindRepeats& repeats) {
    Key key;
    const KindMeasurement& measurement = repeats.measurement;
    key.numbers.push_back(static_cast<double>(measurement.kind));
    for (const auto& [name, value] : measurement.settings) {
        key.words.push_back(name);
        key.numbers.push_back(value);
    }
    for (const KindRepeat& repeat : measurement.repeats) {
        key.numbers.push_back(static_cast<double>(repeat.ends.size()));
        for (const KindEnd& end : repeat.ends) {
            append(key.numbers, end.position);
            append(key.numbers, Eigen::Vector3d(end.noise_m, end.spacing_m, static_cast<double>(end.body)));
            append(key.numbers, end.covariance.value_or(Eigen::Matrix3d::Zero()));
        }
    }
    for (std::size_t i = 0; i < repeats.layers.size(); ++i) {
        const Layer& layer = *scene.layer(repeats.layers[i]);
        key.clouds.push_back(layer.data);
        key.words.push_back(measurement.bodies[i].name);
        const Similarity toScene = sceneFromLayer(layer);
        key.numbers.push_back(toScene.scale);
        key.numbers.push_back(sensorNoise_m(layer.role));
        append(key.numbers, toScene.pose.matrix());
        if (!measurement.bodies[i].pose) continue;
        append(key.numbers, measurement.bodies[i].pose->covariance);
        append(key.numbers, measurement.bodies[i].pose->pivot_m);
    }
    if (const Layer* base = baseOf(scene, measurement)) {
        key.clouds.push_back(base->data);
        const Similarity toScene = sceneFromLayer(*base);
        key.numbers.push_back(toScene.scale);
        append(key.numbers, toScene.pose.matrix());
        for (const KindRepeat& repeat : measurement.repeats)
            key.numbers.push_back(heightVariance(*base, repeat.ends.front().position));
    }
    return key;
}

void addClouds(const SceneState& scene, KindRepeats& repeats) {
    KindMeasurement& measurement = repeats.measurement;
    const double margin = marginOf(measurement.kind, measurement.settings);
    const Layer* base = baseOf(scene, measurement);
    for (KindRepeat& repeat : measurement.repeats) {
        if (base) {
            const Eigen::Vector3d& place = repeat.ends.front().position;
            double variance = heightVariance(*base, place);
            for (const std::string& id : repeats.layers)
                if (id != base->id) variance += heightVariance(*scene.layer(id), place);
            repeat.base = cloudNear(*base, repeat.ends, margin);
            repeat.baseHeight_m = std::sqrt(variance);
        }
        for (std::size_t i = 0; i < repeats.layers.size(); ++i) {
            const bool touched = std::any_of(repeat.ends.begin(), repeat.ends.end(),
                                             [i](const KindEnd& end) { return end.body == i; });
            if (!touched) continue;
            const Layer& layer = *scene.layer(repeats.layers[i]);
            const auto near = cloudNear(layer, repeat.ends, margin);
            repeat.cloud.insert(repeat.cloud.end(), near.begin(), near.end());
            repeat.cloudNoise_m = std::max(repeat.cloudNoise_m, sensorNoise_m(layer.role));
        }
    }
}

}  // namespace

KindOutcome outcomeOf(const SceneState& scene, KindRepeats repeats) {
    if (!kindSpec(repeats.measurement.kind).usesCloud) return kindStatistics(repeats.measurement);
    static std::mutex mutex;
    static std::deque<std::pair<Key, KindOutcome>> remembered;
    Key key = keyOf(scene, repeats);
    {
        const std::lock_guard lock(mutex);
        for (const auto& [each, outcome] : remembered)
            if (each == key) return outcome;
    }
    if (CloudKindsLater* later = CloudKindsLater::current()) return later->leave(std::move(repeats));
    addClouds(scene, repeats);
    KindOutcome outcome = kindStatistics(repeats.measurement);
    const std::lock_guard lock(mutex);
    remembered.emplace_back(std::move(key), outcome);
    if (remembered.size() > kRemembered) remembered.pop_front();
    return outcome;
}

}  // namespace vestige
