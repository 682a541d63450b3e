#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/Picking.h"

namespace vestige {

struct OutlineOptions {
    /// Only what lies at most this far behind the nearest surface under the outline, along the view
    /// direction; nothing: however deep.
    std::optional<double> depth_m;
    bool outside = false;  ///< everything else that is seen, in its place
    /// With it, points found are counted that lie further than this behind the nearest point of their tile of
    /// 4 pixels: what the picture does not show. Not with `outside`.
    std::optional<double> behind_m;
    ClipRegion clips;
};

struct PointsInOutline {
    /// Indices into the layers' clouds, ascending; as many as there are layers.
    std::vector<std::vector<std::uint32_t>> points;
    /// Along the view direction: where the nearest surface under the outline lies, and how deep was taken.
    /// Nothing without a limit, or where nothing lies under the outline.
    std::optional<double> nearest_m;
    std::optional<double> deepest_m;
    std::size_t behind = 0;  ///< of all layers, see OutlineOptions::behind_m
};

/// The points of the visible, unclipped layers that a picture by `camera` shows within a closed outline,
/// given by corners in pixels; points of a layer's `hidden` take no part. Whole nodes of the octrees are
/// taken or left where they lie to one side of it. A point is within by the pixel that it falls into. The
/// nearest surface is where 1 % of the outline's tiles of 4 pixels have their nearest point in front of, so
/// that a stray does not stand for it; what is nearer still is taken, too. The same for any number of
/// threads. ErrorCode::cancelled; ErrorCode::usage for a depth that is not above 0.
Result<PointsInOutline> pointsInOutline(std::span<const PickLayer> layers, const ViewCamera& camera,
                                        std::span<const Eigen::Vector2d> corners,
                                        const OutlineOptions& options, const JobControl& control = {});

}  // namespace vestige
