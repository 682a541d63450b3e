#include "core/filters/NearbyPoints.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "core/base/Parallel.h"
#include "core/filters/CellGrid.h"
#include "core/filters/LoopProgress.h"
#include "core/filters/WorldPoints.h"
#include "core/geometry/Octree.h"

namespace vestige {
namespace {

constexpr std::size_t kCellGrain = 128;
constexpr std::size_t kPointGrain = 1024;
/// Beyond any radius, and its square is still a float.
constexpr float kFarAway = 1e18F;

/// For each point in the grid's order, its place relative to its cell's corner.
std::vector<Eigen::Vector3f> placesInCells(const PointCloud& cloud, const CellGrid& grid) {
    const WorldPoints world(cloud);
    std::vector<Eigen::Vector3f> places(cloud.size());
    parallelFor(grid.cellCount(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            const Eigen::Vector3d corner = grid.corner(cell);
            for (std::uint32_t at = grid.begin(cell); at < grid.end(cell); ++at)
                places[at] = (world[grid.order()[at]] - corner).cast<float>();
        }
    });
    return places;
}

/// Collects the nearby points of cells that are asked for in ascending order. The 27 neighbours lie in 9
/// columns along z; in each a cursor runs along with the cells.
class Collector {
  public:
    Collector(const CellGrid& grid, const std::vector<Eigen::Vector3f>& places, std::size_t firstCell)
        : grid_(grid), places_(places) {
        for (int column = 0; column < 9; ++column)
            cursors_[static_cast<std::size_t>(column)] = grid.firstCell(below(grid.key(firstCell), column));
    }

    NearbyPoints collect(std::size_t cell) {
        x_.clear();
        y_.clear();
        z_.clear();
        NearbyPoints nearby;
        nearby.own = grid_.points(cell);
        for (int column = 0; column < 9; ++column) {
            const std::uint64_t lowest = below(grid_.key(cell), column);
            std::size_t& cursor = cursors_[static_cast<std::size_t>(column)];
            while (cursor < grid_.cellCount() && grid_.key(cursor) < lowest) ++cursor;
            for (std::size_t other = cursor; other < grid_.cellCount() && grid_.key(other) <= lowest + 2;
                 ++other) {
                if (other == cell) nearby.firstOwn = x_.size();
                const double up = static_cast<double>(grid_.key(other) - lowest) - 1;
                add(other, Eigen::Vector3d(column / 3 - 1, column % 3 - 1, up));
            }
        }
        nearby.count = x_.size();
        for (auto* axis : {&x_, &y_, &z_}) axis->resize(NearbyPoints::filled(nearby.count), kFarAway);
        nearby.x = x_;
        nearby.y = y_;
        nearby.z = z_;
        return nearby;
    }

  private:
    /// The key of the lowest of the three neighbours in a column.
    std::uint64_t below(std::uint64_t key, int column) const {
        return key +
               grid_.key(static_cast<std::uint64_t>(column / 3), static_cast<std::uint64_t>(column % 3), 0) -
               grid_.key(1, 1, 1);
    }

    void add(std::size_t other, const Eigen::Vector3d& steps) {
        const Eigen::Vector3f shift = (steps * grid_.size()).cast<float>();
        for (std::uint32_t at = grid_.begin(other); at < grid_.end(other); ++at) {
            x_.push_back(places_[at].x() + shift.x());
            y_.push_back(places_[at].y() + shift.y());
            z_.push_back(places_[at].z() + shift.z());
        }
    }

    const CellGrid& grid_;
    const std::vector<Eigen::Vector3f>& places_;
    std::array<std::size_t, 9> cursors_{};
    std::vector<float> x_;
    std::vector<float> y_;
    std::vector<float> z_;
};

void forCells(const PointCloud& cloud, const CellGrid& grid, LoopProgress& progress,
              const std::function<void(const NearbyPoints&)>& use) {
    const std::vector<Eigen::Vector3f> places = placesInCells(cloud, grid);
    parallelFor(grid.cellCount(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        Collector collector(grid, places, begin);
        for (std::size_t cell = begin; cell < end; ++cell) {
            NearbyPoints nearby = collector.collect(cell);
            // A radius of the cloud's size makes one cell of all points: hours in which it must be
            // cancellable.
            constexpr std::size_t kPairs = 10'000'000;
            const std::size_t piece =
                std::max<std::size_t>(1, kPairs / std::max<std::size_t>(1, nearby.count));
            const auto own = nearby.own;
            for (std::size_t from = 0; from < own.size(); from += piece) {
                nearby.own = own.subspan(from, std::min(piece, own.size() - from));
                use(nearby);
                progress.check();
            }
        }
        progress.done(grid.begin(end) - grid.begin(begin));
    });
}

/// For clouds with strays so far off that a grid would need giant cells: point by point.
void forPoints(const PointCloud& cloud, double radius, LoopProgress& progress,
               const std::function<void(const NearbyPoints&)>& use) {
    const std::shared_ptr<const PointCloud> borrowed(std::shared_ptr<void>{}, &cloud);
    const Octree octree(borrowed);
    const WorldPoints world(cloud);
    parallelFor(cloud.size(), kPointGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<Octree::Neighbour> found;
        std::array<std::vector<float>, 3> axes;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t self = octree.order()[i];
            const Eigen::Vector3f& offset = cloud.offsets()[self];
            // What residuals add to the offsets of both points is less than their last bits.
            const double unsure = 1e-6 * static_cast<double>(offset.cwiseAbs().maxCoeff());
            octree.radiusSearch(offset, static_cast<float>((radius + unsure) * (1 + 1e-6)), found);
            NearbyPoints nearby;
            nearby.own = octree.order().subspan(i, 1);
            nearby.count = found.size();
            for (int axis = 0; axis < 3; ++axis) {
                auto& values = axes[static_cast<std::size_t>(axis)];
                values.clear();
                for (const Octree::Neighbour& other : found)
                    values.push_back(
                        static_cast<float>(world.along(axis, other.point) - world.along(axis, self)));
                values.resize(NearbyPoints::filled(found.size()), kFarAway);
            }
            while (found[nearby.firstOwn].point != self) ++nearby.firstOwn;
            nearby.x = axes[0];
            nearby.y = axes[1];
            nearby.z = axes[2];
            use(nearby);
        }
        progress.done(end - begin);
    });
}

}  // namespace

void forNearbyPoints(const PointCloud& cloud, double radius, const std::string& step,
                     const JobControl& control, const std::function<void(const NearbyPoints&)>& use) {
    LoopProgress progress(control, cloud.size(), step);
    // A hair wider than the radius: rounding may not put a neighbour two cells away.
    const double least = radius * (1 + 1e-6);
    const double size = CellLayout::coveringSize(cloud.bounds(), least);
    if (size > 2 * least) {
        forPoints(cloud, radius, progress, use);
    } else {
        forCells(cloud, CellGrid(cloud, size, control), progress, use);
    }
}

}  // namespace vestige
