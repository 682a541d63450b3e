#include "core/geometry/PointsInOutline.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/Parallel.h"
#include "core/geometry/OutlineMask.h"

namespace vestige {
namespace {

using Cover = OutlineMask::Cover;
constexpr std::size_t kGrain = 16384;
constexpr int kTile_px = 4;
constexpr double kStrayShare = 0.01;
/// So many points at most are asked where the nearest surface lies: several for each tile of a picture.
constexpr std::size_t kMostForSurface = 2'000'000;

/// Takes a layer's offsets into the picture: right and up in metres, and the depth.
struct Projection {
    Eigen::Matrix3d axes;
    Eigen::Vector3d origin;
    double perMetre;  ///< pixels, at depth 1 of a perspective camera
    double halfWidth;
    double halfHeight;
    bool parallel;

    Projection(const PickLayer& layer, const ViewCamera& camera)
        : perMetre(1 / camera.metresPerPixel(1)),
          halfWidth(0.5 * camera.width_px),
          halfHeight(0.5 * camera.height_px),
          parallel(camera.parallel) {
        const Eigen::Vector3d forward = camera.direction();
        const Eigen::Vector3d right = forward.cross(camera.viewUp).normalized();
        axes << right.transpose(), right.cross(forward).transpose(), forward.transpose();
        origin = axes * (layer.worldFromLayer * layer.octree->cloud().origin() - camera.position);
        axes *= layer.worldFromLayer.pose.linear() * layer.worldFromLayer.scale;
    }
    Eigen::Vector3d place(const Eigen::Vector3f& offset) const {
        return axes * offset.cast<double>() + origin;
    }
    bool inFront(const Eigen::Vector3d& place) const { return parallel || place.z() > 0; }
    Eigen::Vector2d pixel(const Eigen::Vector3d& place) const {
        const double scale = parallel ? perMetre : perMetre / place.z();
        return {halfWidth + scale * place.x(), halfHeight - scale * place.y()};
    }
};

/// What the section keeps, asked in a layer's offsets.
struct Clips {
    std::vector<Eigen::Vector4d> planes;
    const ClipRegion& region;
    Eigen::Matrix3d turn;
    Eigen::Vector3d origin;

    Clips(const PickLayer& layer, const ClipRegion& world)
        : region(world),
          turn(layer.worldFromLayer.pose.linear() * layer.worldFromLayer.scale),
          origin(layer.worldFromLayer * layer.octree->cloud().origin()) {
        for (const ClipPlane& plane : world.planes) {
            Eigen::Vector4d here;
            here << turn.transpose() * plane.normal, plane.normal.dot(origin) + plane.distance;
            planes.push_back(here);
        }
    }
    bool keeps(const Eigen::Vector3f& offset) const {
        const Eigen::Vector3d place = offset.cast<double>();
        const bool inside = std::all_of(planes.begin(), planes.end(), [&](const Eigen::Vector4d& plane) {
            return plane.head<3>().dot(place) + plane.w() >= 0;
        });
        return inside != region.inverted;
    }
    Kept keptOf(const Octree::Node& node) const {
        const Eigen::Vector3d middle = 0.5 * (node.min.cast<double>() + node.max.cast<double>());
        return kept(region, turn, origin, middle, node.max.cast<double>() - middle);
    }
};

/// A range of a layer's octree order, and what is still to be asked of its points.
struct Piece {
    std::uint32_t begin;
    std::uint32_t end;
    bool outline;
    bool clip;
};

class LayerSearch {
  public:
    LayerSearch(const PickLayer& layer, const ViewCamera& camera, const OutlineMask& mask,
                const ClipRegion& clips)
        : layer_(layer), mask_(mask), projection_(layer, camera), clips_(layer, clips) {
        if (!layer.octree->nodes().empty()) collect(0);
    }

    /// use(point, place in the picture) for each point within the outline, many threads at once; of every
    /// `step` points, which lie near each other, the first.
    template <class Use>
    void each(const JobControl& control, std::uint32_t step, const Use& use) const {
        const auto order = layer_.octree->order();
        const auto& offsets = layer_.octree->cloud().offsets();
        const auto visit = [&](const Piece& piece, std::uint32_t begin, std::uint32_t end) {
            for (std::uint32_t at = (begin + step - 1) / step * step; at < end; at += step) {
                const std::uint32_t point = order[at];
                if (layer_.hidden && (*layer_.hidden)[point]) continue;
                const Eigen::Vector3d place = projection_.place(offsets[point]);
                if (piece.outline) {
                    if (!projection_.inFront(place)) continue;
                    const Eigen::Vector2d pixel = projection_.pixel(place);
                    if (!mask_.contains(pixel.x(), pixel.y())) continue;
                }
                if (piece.clip && !clips_.keeps(offsets[point])) continue;
                use(point, place);
            }
        };
        parallelFor(pieces_.size(), 16, [&](std::size_t first, std::size_t last) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            for (std::size_t i = first; i < last; ++i) visit(pieces_[i], pieces_[i].begin, pieces_[i].end);
        });
    }

    bool keeps(std::uint32_t point) const {
        return !(layer_.hidden && (*layer_.hidden)[point]) &&
               clips_.keeps(layer_.octree->cloud().offsets()[point]);
    }
    Eigen::Vector2d pixel(const Eigen::Vector3d& place) const { return projection_.pixel(place); }
    std::size_t size() const { return layer_.octree->cloud().size(); }
    /// Points that have to be asked or taken whole.
    std::size_t asked() const {
        std::size_t count = 0;
        for (const Piece& piece : pieces_) count += piece.end - piece.begin;
        return count;
    }

  private:
    Cover coverOf(const Octree::Node& node) const {
        Eigen::Vector2d least = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
        Eigen::Vector2d most = -least;
        int behind = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3f offset(corner & 1 ? node.max.x() : node.min.x(),
                                         corner & 2 ? node.max.y() : node.min.y(),
                                         corner & 4 ? node.max.z() : node.min.z());
            const Eigen::Vector3d place = projection_.place(offset);
            if (!projection_.inFront(place)) {
                ++behind;
                continue;
            }
            const Eigen::Vector2d pixel = projection_.pixel(place);
            least = least.cwiseMin(pixel);
            most = most.cwiseMax(pixel);
        }
        if (behind == 8) return Cover::none;
        return behind > 0 ? Cover::part : mask_.cover(least, most);
    }

    void collect(std::uint32_t index) {
        const Octree::Node& node = layer_.octree->nodes()[index];
        const Cover seen = coverOf(node);
        const Kept kept = clips_.keptOf(node);
        if (seen == Cover::none || kept == Kept::none) return;
        const bool decided = seen == Cover::all && kept == Kept::all;
        if (decided || node.childCount == 0) {
            // Large nodes in pieces that threads can share.
            for (std::uint32_t at = node.begin; at < node.end; at += kGrain)
                pieces_.push_back({at, std::min<std::uint32_t>(node.end, at + kGrain), seen != Cover::all,
                                   kept != Kept::all});
            return;
        }
        for (std::uint32_t child = 0; child < node.childCount; ++child) collect(node.firstChild + child);
    }

    const PickLayer& layer_;
    const OutlineMask& mask_;
    Projection projection_;
    Clips clips_;
    std::vector<Piece> pieces_;
};

/// The nearest depth of each tile of the picture.
class NearestDepths {
  public:
    NearestDepths(int width, int height)
        : columns_((width + kTile_px - 1) / kTile_px),
          depths_(static_cast<std::size_t>(columns_) * ((height + kTile_px - 1) / kTile_px)) {
        for (auto& depth : depths_) depth = kNone;
    }

    void add(const Eigen::Vector2d& pixel, double depth) {
        std::atomic<std::uint32_t>& held = depths_[tileOf(pixel)];
        const std::uint32_t key = keyOf(static_cast<float>(depth));
        std::uint32_t before = held.load(std::memory_order_relaxed);
        while (key < before && !held.compare_exchange_weak(before, key, std::memory_order_relaxed)) {
        }
    }

    /// Whether a place lies so far behind the nearest of its tile.
    bool isBehind(const Eigen::Vector2d& pixel, double depth, double by_m) const {
        const std::uint32_t held = depths_[tileOf(pixel)].load(std::memory_order_relaxed);
        return held != kNone && depth > depthOf(held) + by_m;
    }

    std::optional<double> surface() const {
        std::vector<std::uint32_t> met;
        for (const auto& depth : depths_)
            if (depth != kNone) met.push_back(depth);
        if (met.empty()) return std::nullopt;
        const auto place =
            met.begin() + static_cast<std::ptrdiff_t>(kStrayShare * static_cast<double>(met.size()));
        std::nth_element(met.begin(), place, met.end());
        return depthOf(*place);
    }

  private:
    std::size_t tileOf(const Eigen::Vector2d& pixel) const {
        const auto column = static_cast<std::size_t>(pixel.x()) / kTile_px;
        const auto row = static_cast<std::size_t>(pixel.y()) / kTile_px;
        return row * static_cast<std::size_t>(columns_) + column;
    }
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    /// Numbers that ascend as the depths do, those below 0 of a parallel camera too.
    static std::uint32_t keyOf(float depth) {
        const auto bits = std::bit_cast<std::uint32_t>(depth);
        return bits & 0x80000000U ? ~bits : bits | 0x80000000U;
    }
    static double depthOf(std::uint32_t key) {
        return std::bit_cast<float>(key & 0x80000000U ? key & 0x7fffffffU : ~key);
    }

    int columns_;
    std::vector<std::atomic<std::uint32_t>> depths_;
};

/// The indices that `chosen` answers, ascending.
template <class Chosen>
std::vector<std::uint32_t> indicesWhere(std::size_t count, const Chosen& chosen) {
    std::vector<std::vector<std::uint32_t>> parts((count + kGrain - 1) / kGrain);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (chosen(static_cast<std::uint32_t>(i))) parts[chunk].push_back(static_cast<std::uint32_t>(i));
    });
    std::vector<std::uint32_t> all;
    std::size_t total = 0;
    for (const auto& part : parts) total += part.size();
    all.reserve(total);
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace

Result<PointsInOutline> pointsInOutline(std::span<const PickLayer> layers, const ViewCamera& camera,
                                        std::span<const Eigen::Vector2d> corners,
                                        const OutlineOptions& options, const JobControl& control) {
    if (options.depth_m && !(*options.depth_m > 0))
        return fail(ErrorCode::usage, "the depth of a cut is not above 0 m", "outline",
                    "expected metres above 0, or no limit");
    return guarded("outline", [&]() -> Result<PointsInOutline> {
        const OutlineMask mask(corners, camera.width_px, camera.height_px);
        PointsInOutline result;
        std::vector<LayerSearch> searches;
        searches.reserve(layers.size());
        for (const PickLayer& layer : layers) searches.emplace_back(layer, camera, mask, options.clips);
        const bool counts = options.behind_m && !options.outside;
        NearestDepths depths(camera.width_px, camera.height_px);
        if (options.depth_m || counts) {
            std::size_t asked = 0;
            for (const LayerSearch& search : searches) asked += search.asked();
            const auto step = static_cast<std::uint32_t>(1 + asked / kMostForSurface);
            for (const LayerSearch& search : searches)
                search.each(control, step, [&](std::uint32_t, const Eigen::Vector3d& place) {
                    // Whole nodes were not asked for their pixels; rounding may put one on the picture's
                    // edge.
                    const Eigen::Vector2d pixel = search.pixel(place);
                    if (mask.contains(pixel.x(), pixel.y())) depths.add(pixel, place.z());
                });
            if (options.depth_m) result.nearest_m = depths.surface();
            if (result.nearest_m) result.deepest_m = *result.nearest_m + *options.depth_m;
        }
        std::atomic<std::size_t> behind = 0;
        const double limit = result.deepest_m.value_or(std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < searches.size(); ++i) {
            control.progress(static_cast<double>(i) / static_cast<double>(searches.size()), "points within");
            const LayerSearch& search = searches[i];
            std::vector<std::uint8_t> within(search.size(), 0);
            search.each(control, 1, [&](std::uint32_t point, const Eigen::Vector3d& place) {
                within[point] = place.z() <= limit;
                if (!counts || place.z() > limit) return;
                const Eigen::Vector2d pixel = search.pixel(place);
                if (mask.contains(pixel.x(), pixel.y()) &&
                    depths.isBehind(pixel, place.z(), *options.behind_m))
                    behind.fetch_add(1, std::memory_order_relaxed);
            });
            result.points.push_back(indicesWhere(search.size(), [&](std::uint32_t point) {
                return options.outside ? !within[point] && search.keeps(point) : within[point] != 0;
            }));
        }
        result.behind = behind;
        return result;
    });
}

}  // namespace vestige
