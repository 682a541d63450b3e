#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/ParameterSpec.h"
#include "core/geometry/ClipRegion.h"
#include "core/geometry/Octree.h"
#include "core/geometry/ViewCamera.h"

namespace vestige {

/// A visible layer as the picture shows it. Layers that are hidden are left out by the caller.
struct PickLayer {
    std::uint32_t layer = 0;  ///< the caller's number, returned in Pick
    const Octree* octree = nullptr;
    Similarity worldFromLayer;
    /// Points that are not drawn (not 0), by index; null: all are.
    const std::vector<std::uint8_t>* hidden = nullptr;
};

struct Pick {
    std::uint32_t layer = 0;
    std::uint32_t point = 0;  ///< index into that layer's cloud
    Eigen::Vector3d world;    ///< metres
    double depth_m = 0;
    double localSpacing_m = 0;
    double cursorDistance_px = 0;
};

struct PickOptions {
    double radius_px = 6;
    double hiddenBehindSpacings = 3;
    ClipRegion clips;
};

/// The point that a click at `cursor` means: of all points of the visible, unclipped layers within
/// `radius_px` of it, those hidden (another candidate is nearer to the viewer by more than
/// `hiddenBehindSpacings` local spacings of that nearer one) are dropped; of the rest the one nearest to the
/// cursor wins, ties by depth, layer, index. Window, command line, simulator and tests all call this one
/// function. Nothing when no candidate is left.
std::optional<Pick> pickPoint(std::span<const PickLayer> layers, const ViewCamera& camera,
                              const Eigen::Vector2d& cursor, const PickOptions& options = {});

}  // namespace vestige
