#include "core/simulation/Aims.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/Random.h"

namespace vestige {
namespace {

constexpr std::uint64_t kAimStreams = 500;
constexpr int kWidth_px = 1400;
constexpr int kHeight_px = 900;

struct End {
    const FeaturePoint* feature;
    std::size_t index;
    const ShownLayer* layer = nullptr;
};

/// A camera that looks at `middle` from `lookFrom` at the layer's scale, in the layer's coordinates.
SimulatedView viewOf(const ShownLayer& layer, const Eigen::Vector3d& middle,
                     const Eigen::Vector3d& lookFrom) {
    const Eigen::Vector3d up =
        std::abs(lookFrom.z()) < 0.8 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    SimulatedView view;
    view.frame = layer.ownFrame ? layer.id : "";
    ViewCamera& camera = view.camera;
    camera.width_px = kWidth_px;
    camera.height_px = kHeight_px;
    camera.verticalAngle_rad = 2 * std::atan(0.5 * kHeight_px * layer.metresPerPixel / layer.viewDistance_m);
    camera.focalPoint = layer.layerFromSite * middle;
    camera.position = layer.layerFromSite * (middle + layer.viewDistance_m * lookFrom);
    camera.viewUp = layer.layerFromSite.pose.linear() * up;
    return view;
}

class Analyst {
  public:
    Analyst(const SurfaceModel& surfaces, const std::vector<ShownLayer>& layers, const AimOptions& options)
        : surfaces_(surfaces), layers_(layers), options_(options) {}

    void measure(const MeasurementSpec& spec, std::uint64_t number, Aiming& aiming) const {
        AimedMeasurement measured{spec.object, spec.tape_m, {}};
        std::vector<std::string> methods;
        for (const ShownLayer& layer : layers_)
            if (std::find(methods.begin(), methods.end(), layer.method) == methods.end())
                methods.push_back(layer.method);
        for (std::size_t i = 0; i < methods.size(); ++i) {
            std::array<End, 2> ends{find(spec.from), find(spec.to)};
            if (!chooseLayers(methods[i], ends)) continue;
            // A stream per measurement and method: what one layer shows does not change other clicks.
            Random random(options_.seed, kAimStreams + 16 * number + i);
            measured.aims[methods[i]] = aim(ends, random, aiming);
        }
        aiming.measurements.push_back(std::move(measured));
    }

  private:
    End find(const std::string& name) const {
        const FeaturePoint* feature = surfaces_.feature(name);
        return {feature, static_cast<std::size_t>(feature - surfaces_.features.data())};
    }

    bool chooseLayers(const std::string& method, std::array<End, 2>& ends) const {
        std::vector<const ShownLayer*> usable;
        for (const bool handheld : {true, false})
            for (const ShownLayer& layer : layers_)
                if (layer.method == method && layer.handheld == handheld) usable.push_back(&layer);
        for (const ShownLayer* layer : usable) {
            if (!layer->shows[ends[0].index] || !layer->shows[ends[1].index]) continue;
            ends[0].layer = ends[1].layer = layer;
            return true;
        }
        for (End& end : ends) {
            const auto found = std::find_if(usable.begin(), usable.end(),
                                            [&](const ShownLayer* layer) { return layer->shows[end.index]; });
            if (found == usable.end()) return false;
            end.layer = *found;
        }
        return true;
    }

    std::vector<std::array<SimulatedAim, 2>> aim(const std::array<End, 2>& ends, Random& random,
                                                 Aiming& aiming) const {
        const auto& [a, b] = ends;
        const double length = (a.feature->position - b.feature->position).norm();
        const bool together = a.layer == b.layer && length < 0.5 * kHeight_px * a.layer->metresPerPixel;
        std::array<std::string, 2> names;
        for (std::size_t i = 0; i < 2; ++i) {
            const End& end = ends[i];
            names[i] = end.layer->id + ": " + a.feature->name + (together ? " to " + b.feature->name : "");
            if (!together) names[i] = end.layer->id + ": " + end.feature->name;
            const Eigen::Vector3d middle =
                together ? Eigen::Vector3d(0.5 * (a.feature->position + b.feature->position))
                         : end.feature->position;
            const Eigen::Vector3d look =
                together ? Eigen::Vector3d((a.feature->lookFrom + b.feature->lookFrom).normalized())
                         : end.feature->lookFrom;
            aiming.views.emplace(names[i], viewOf(*end.layer, middle, look));
        }
        std::vector<std::array<SimulatedAim, 2>> repeats;
        for (int repeat = 0; repeat < options_.repeats; ++repeat) {
            std::array<SimulatedAim, 2> pair;
            for (std::size_t i = 0; i < 2; ++i) {
                const End& end = ends[i];
                const ViewCamera& camera = aiming.views.at(names[i]).camera;
                const auto seen = camera.project(end.layer->layerFromSite * end.feature->position);
                const Eigen::Vector2d error(random.normal(0, options_.sigma_px),
                                            random.normal(0, options_.sigma_px));
                pair[i] = {names[i], seen->pixel + error, end.layer->id, end.feature->snap};
            }
            repeats.push_back(pair);
        }
        return repeats;
    }

    const SurfaceModel& surfaces_;
    const std::vector<ShownLayer>& layers_;
    const AimOptions& options_;
};

}  // namespace

Aiming aimAtFeatures(const SceneSpec& spec, const SurfaceModel& surfaces,
                     const std::vector<ShownLayer>& layers, const AimOptions& options) {
    const Analyst analyst(surfaces, layers, options);
    Aiming aiming;
    for (std::uint64_t i = 0; i < spec.measurements.size(); ++i)
        analyst.measure(spec.measurements[i], i, aiming);
    return aiming;
}

}  // namespace vestige
