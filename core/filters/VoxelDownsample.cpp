#include "core/filters/VoxelDownsample.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Numbers.h"
#include "core/base/Parallel.h"
#include "core/filters/CellAttributes.h"
#include "core/filters/CellBuckets.h"
#include "core/filters/CellGrid.h"
#include "core/filters/LoopProgress.h"
#include "core/filters/VoxelMeans.h"
#include "core/filters/WorldPoints.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

constexpr std::size_t kCellGrain = 4096;
constexpr std::uint32_t kAhead = 16;

/// Mean of the cell's points, summed from the cell's corner so that no digit is lost far from the origin.
Eigen::Vector3d centroid(const WorldPoints& world, const CellGrid& grid, std::size_t cell) {
    const Eigen::Vector3d corner = grid.corner(cell);
    double x = 0;
    double y = 0;
    double z = 0;
    for (std::uint32_t at = grid.begin(cell); at < grid.end(cell); ++at) {
        const std::uint32_t point = grid.order()[at];
        if (at + kAhead < grid.order().size()) world.prefetch(grid.order()[at + kAhead]);
        x += world.along(0, point) - corner.x();
        y += world.along(1, point) - corner.y();
        z += world.along(2, point) - corner.z();
    }
    return corner + Eigen::Vector3d(x, y, z) / static_cast<double>(grid.points(cell).size());
}

std::uint32_t nearestTo(const Eigen::Vector3d& place, const WorldPoints& world,
                        std::span<const std::uint32_t> points) {
    std::uint32_t best = points.front();
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t point : points) {
        const double distance = (world[point] - place).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = point;
    }
    return best;
}

/// For clouds of few points in very many cells.
PointCloud representedSparsely(const PointCloud& cloud, double size, VoxelRepresentative representative,
                               const JobControl& control) {
    const CellGrid grid(cloud, size, control);
    const WorldPoints world(cloud);
    LoopProgress progress(control, grid.cellCount(), "voxels");
    if (representative == VoxelRepresentative::nearest) {
        std::vector<std::uint32_t> chosen(grid.cellCount());
        parallelFor(grid.cellCount(), kCellGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell)
                chosen[cell] = nearestTo(centroid(world, grid, cell), world, grid.points(cell));
            progress.done(end - begin);
        });
        return cloud.select(chosen);
    }
    PointCloudBuilder builder(cloud.origin());
    builder.resize(grid.cellCount());
    parallelFor(grid.cellCount(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell)
            builder.setPoint(cell, centroid(world, grid, cell));
        progress.done(end - begin);
    });
    builder.attributes() = averagedAttributes(cloud.attributes(), grid.members());
    return std::move(builder).build();
}

bool hasAttributes(const PointAttributes& a) {
    return !(a.intensity.empty() && a.color.empty() && a.classification.empty() && a.gpsTime.empty() &&
             a.normal.empty() && a.pointSource.empty() && a.returnNumber.empty() && a.returnCount.empty());
}

PointCloud represented(const PointCloud& cloud, double size, VoxelRepresentative representative,
                       const JobControl& control) {
    if (cloud.empty()) return cloud;
    const CellLayout layout(cloud.bounds(), size);
    if (!CellBuckets::covers(layout)) return representedSparsely(cloud, size, representative, control);
    const PointSpan points(cloud);
    if (representative == VoxelRepresentative::nearest)
        return cloud.select(voxelMeans(layout, points, VoxelWants::nearest, control).nearest);
    const bool attributes = hasAttributes(cloud.attributes());
    VoxelMeans means =
        voxelMeans(layout, points, attributes ? VoxelWants::members : VoxelWants::means, control);
    const auto isFar = [](const Eigen::Vector3f& offset) {
        return offset.cwiseAbs().maxCoeff() > PointCloudBuilder::kExactRange;
    };
    if (std::none_of(means.offsets.begin(), means.offsets.end(), isFar)) means.residuals.clear();
    PointAttributes averaged;
    if (attributes) averaged = averagedAttributes(cloud.attributes(), means.members);
    return {cloud.origin(), std::move(means.offsets), std::move(means.residuals), std::move(averaged)};
}

Status checkSize(const PointCloud& cloud, double size) {
    if (!(size > 0) || !std::isfinite(size))
        return fail(ErrorCode::usage, "the voxel size " + exactText(size) + " is not a length", "voxel",
                    "expected a number above 0");
    if (!CellLayout::covers(cloud.bounds(), size))
        return fail(ErrorCode::usage,
                    "the cloud is " + exactText(cloud.bounds().extent().maxCoeff()) +
                        " long and has too many voxels of size " + exactText(size) + " along one side",
                    "voxel", "expected at most 2097149; a larger voxel is needed");
    return {};
}

}  // namespace

Result<PointCloud> downsample(const PointCloud& cloud, double size, VoxelRepresentative representative,
                              const JobControl& control) {
    if (const Status checked = checkSize(cloud, size); !checked) return fail(checked.error());
    return guarded("voxel",
                   [&]() -> Result<PointCloud> { return represented(cloud, size, representative, control); });
}

Result<std::vector<VoxelLevel>> downsampleLevels(const PointCloud& cloud, double finest, double coarsest,
                                                 VoxelRepresentative representative,
                                                 const JobControl& control) {
    if (!(coarsest >= finest) || !std::isfinite(coarsest))
        return fail(
            ErrorCode::usage,
            "the coarsest voxel " + exactText(coarsest) + " is smaller than the finest " + exactText(finest),
            "voxel");
    if (const Status checked = checkSize(cloud, finest); !checked) return fail(checked.error());
    std::vector<double> sizes;
    // A millionth of room, so that a coarsest size given as a rounded step of the schedule is reached.
    for (double size = finest; size <= coarsest * (1 + 1e-6); size /= kVoxelFactor) sizes.push_back(size);
    std::vector<VoxelLevel> levels;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto part = [&](std::size_t step) {
            return static_cast<double>(step) / static_cast<double>(sizes.size());
        };
        auto level = downsample(cloud, sizes[i], representative, control.sub(part(i), part(i + 1)));
        if (!level) return fail(level.error());
        levels.push_back({sizes[i], std::move(*level)});
    }
    return levels;
}

}  // namespace vestige
