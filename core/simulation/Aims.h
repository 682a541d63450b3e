#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/ViewCamera.h"
#include "core/simulation/SceneSpec.h"
#include "core/simulation/SurfaceModel.h"

namespace vestige {

/// A layer of the simulated survey as the analyst sees it.
struct ShownLayer {
    std::string id;
    std::string method;  ///< "lidar", "photogrammetry"
    bool handheld = false;
    bool ownFrame = false;     ///< views of it are kept in the layer's own coordinates
    Similarity layerFromSite;  ///< file coordinates from site metres
    double metresPerPixel = 0;
    double viewDistance_m = 0;
    std::vector<bool> shows;  ///< per feature of the surfaces: enough echoes of the very part near it
};

/// A recorded click: which view, where, on what.
struct SimulatedAim {
    std::string view;
    Eigen::Vector2d pixel;
    std::string layer;
    std::string snap{};  ///< the feature's; empty: nothing is fitted
};

struct AimedMeasurement {
    std::string object;
    double tape_m = 0;
    /// By method; a method with which the length cannot be measured is absent.
    std::map<std::string, std::vector<std::array<SimulatedAim, 2>>> aims;
};

struct SimulatedView {
    ViewCamera camera;
    std::string frame;  ///< layer id, or empty for the target's frame
};

struct Aiming {
    std::map<std::string, SimulatedView> views;
    std::vector<AimedMeasurement> measurements;
};

struct AimOptions {
    std::uint64_t seed = 1;
    double sigma_px = 2;  ///< pointing error in x and in y
    int repeats = 3;
};

/// The analyst's clicks: for every measurement and method the layer that shows both ends (a handheld one
/// first, then the others), else for each end a layer that shows it; a view near the feature from where it
/// can be seen; the true feature projected into it, plus a pointing error that differs from repeat to repeat.
/// The true place is used for aiming only: which point is hit is found later by pickPoint.
Aiming aimAtFeatures(const SceneSpec& spec, const SurfaceModel& surfaces,
                     const std::vector<ShownLayer>& layers, const AimOptions& options);

}  // namespace vestige
