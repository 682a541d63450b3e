#include "core/geometry/Picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace vestige {
namespace {

/// The cone (parallel camera: the cylinder) of pixels within the pick radius, asked in one layer's offsets
/// whether a box can hold a candidate. In the camera's axes, with depth z, a point is a candidate when
/// |(x, y) - (sx, sy)| <= reach, all three linear in z; so x - sx and y - sy are linear in the point.
class LayerCone {
  public:
    LayerCone(const PickLayer& layer, const ViewCamera& camera, const Eigen::Vector2d& cursor,
              const PickOptions& options)
        : layer_(layer), camera_(camera), cursor_(cursor), options_(options) {
        const Eigen::Vector3d forward = camera.direction();
        const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
        const Eigen::Vector3d up = right.cross(forward);
        const double pixel = camera.metresPerPixel(1);
        const double aside = (cursor.x() - 0.5 * camera.width_px) * pixel;
        const double above = (0.5 * camera.height_px - cursor.y()) * pixel;
        Eigen::Matrix3d axes;
        axes << right.transpose(), up.transpose(), forward.transpose();
        Eigen::Vector3d origin = axes * (worldOrigin() - camera.position);
        axes *= layer.worldFromLayer.pose.linear() * layer.worldFromLayer.scale;
        if (camera.parallel) {
            origin -= Eigen::Vector3d(aside, above, 0);
        } else {
            const Eigen::Vector3d slant(aside, above, 0);
            axes -= slant * axes.row(2).eval();
            origin -= slant * origin.z();
        }
        axes_ = axes;
        reach_ = axes.cwiseAbs();
        origin_ = origin;
        pixel_ = pixel;
        rounding_ = 1e-9 * origin.norm() + 1e-14 * (worldOrigin().norm() + camera.position.norm());
    }

    /// The least depth that a candidate in the node can have; nothing when it holds none.
    std::optional<double> nearestDepth(const Octree::Node& node) const {
        const Eigen::Vector3d least = node.min.cast<double>();
        const Eigen::Vector3d most = node.max.cast<double>();
        const Eigen::Vector3d middle = 0.5 * (least + most);
        // Residuals of far points and rounding lie within a float's last bit.
        const double slack = 1e-6 * std::max(least.cwiseAbs().maxCoeff(), most.cwiseAbs().maxCoeff());
        const Eigen::Vector3d half = 0.5 * (most - least) + Eigen::Vector3d::Constant(slack);
        const Eigen::Vector3d centre = axes_ * middle + origin_;
        const Eigen::Vector3d extent = reach_ * half + Eigen::Vector3d::Constant(rounding_);
        const double farthest = centre.z() + extent.z();
        if (!camera_.parallel && farthest <= 0) return std::nullopt;
        const double radius = (1 + 1e-9) * options_.radius_px * pixel_ * (camera_.parallel ? 1 : farthest);
        const double x = std::max(0.0, std::abs(centre.x()) - extent.x());
        const double y = std::max(0.0, std::abs(centre.y()) - extent.y());
        if (x * x + y * y > radius * radius || isClipped(middle, half)) return std::nullopt;
        return centre.z() - extent.z();
    }

    /// The point as a pick, without its spacing; nothing unless it is a candidate.
    std::optional<Pick> candidate(std::uint32_t point) const {
        if (layer_.hidden && (*layer_.hidden)[point]) return std::nullopt;
        Pick pick;
        pick.world = layer_.worldFromLayer * layer_.octree->cloud().point(point);
        const auto seen = camera_.project(pick.world);
        if (!seen) return std::nullopt;
        pick.cursorDistance_px = (seen->pixel - cursor_).norm();
        if (!(pick.cursorDistance_px <= options_.radius_px)) return std::nullopt;
        if (!options_.clips.keeps(pick.world)) return std::nullopt;
        pick.layer = layer_.layer;
        pick.point = point;
        pick.depth_m = seen->depth_m;
        return pick;
    }

    const Octree& octree() const { return *layer_.octree; }
    double spacing(std::uint32_t point) const {
        return layer_.worldFromLayer.scale * static_cast<double>(octree().localSpacing(point));
    }

  private:
    Eigen::Vector3d worldOrigin() const { return layer_.worldFromLayer * layer_.octree->cloud().origin(); }

    bool isClipped(const Eigen::Vector3d& middle, const Eigen::Vector3d& half) const {
        if (options_.clips.planes.empty()) return options_.clips.inverted;
        const Eigen::Vector3d origin = worldOrigin();
        const double rounding = 1e-12 * (origin.norm() + half.norm());
        return kept(options_.clips, layer_.worldFromLayer.pose.linear() * layer_.worldFromLayer.scale, origin,
                    middle, half, rounding) == Kept::none;
    }

    const PickLayer& layer_;
    const ViewCamera& camera_;
    const Eigen::Vector2d& cursor_;
    const PickOptions& options_;
    Eigen::Matrix3d axes_;
    Eigen::Matrix3d reach_;
    Eigen::Vector3d origin_;
    double pixel_ = 0;
    double rounding_ = 0;
};

struct Waiting {
    double depth_m;
    std::size_t cone;
    std::uint32_t node;
    friend bool operator>(const Waiting& a, const Waiting& b) { return a.depth_m > b.depth_m; }
};

}  // namespace

std::optional<Pick> pickPoint(std::span<const PickLayer> layers, const ViewCamera& camera,
                              const Eigen::Vector2d& cursor, const PickOptions& options) {
    std::vector<LayerCone> cones;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
    const auto enter = [&](std::size_t cone, std::uint32_t node) {
        if (const auto depth = cones[cone].nearestDepth(cones[cone].octree().nodes()[node]))
            waiting.push({*depth, cone, node});
    };
    for (const PickLayer& layer : layers) {
        if (!layer.octree || layer.octree->nodes().empty()) continue;
        cones.emplace_back(layer, camera, cursor, options);
        enter(cones.size() - 1, 0);
    }

    // Boxes from near to far. A candidate hides all that is deeper than its depth plus some spacings; once
    // the nearest box left is deeper than the least such limit, the rest is hidden and hides nothing more.
    double limit = std::numeric_limits<double>::infinity();
    struct Found {
        Pick pick;
        std::size_t cone;
    };
    std::vector<Found> candidates;
    std::vector<Pick> here;
    while (!waiting.empty() && waiting.top().depth_m <= limit) {
        const Waiting next = waiting.top();
        waiting.pop();
        const LayerCone& cone = cones[next.cone];
        const Octree::Node& node = cone.octree().nodes()[next.node];
        for (std::uint32_t child = 0; child < node.childCount; ++child)
            enter(next.cone, node.firstChild + child);
        if (node.childCount > 0) continue;
        here.clear();
        for (std::uint32_t at = node.begin; at < node.end; ++at)
            if (auto pick = cone.candidate(cone.octree().order()[at])) here.push_back(*pick);
        std::sort(here.begin(), here.end(),
                  [](const Pick& a, const Pick& b) { return a.depth_m < b.depth_m; });
        for (const Pick& pick : here) {
            if (pick.depth_m > limit) break;
            candidates.push_back({pick, next.cone});
            // At the limit itself it can lower it no more; points that all coincide are many.
            if (pick.depth_m == limit) continue;
            limit = std::min(limit, pick.depth_m + options.hiddenBehindSpacings * cone.spacing(pick.point));
        }
    }

    const Found* best = nullptr;
    const auto rank = [](const Pick& pick) {
        return std::tuple(pick.cursorDistance_px, pick.depth_m, pick.layer, pick.point);
    };
    for (const Found& found : candidates)
        if (found.pick.depth_m <= limit && (!best || rank(found.pick) < rank(best->pick))) best = &found;
    if (!best) return std::nullopt;
    Pick pick = best->pick;
    pick.localSpacing_m = cones[best->cone].spacing(pick.point);
    return pick;
}

}  // namespace vestige
