#include "core/registration/global/SearchVoxel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/registration/ndt/CellMoments.h"
#include "core/registration/ndt/NormalDistributions.h"

namespace vestige {
namespace {

constexpr double kVoxelsPerRadius = 40;
constexpr double kSpacings = 1.5;
constexpr double kThicknesses = 3;
constexpr double kCellsPerDiagonal = 64;

std::vector<Eigen::Vector3f> offsetsOf(const PointCloud& cloud) {
    std::vector<Eigen::Vector3f> offsets(cloud.size());
    const Eigen::Vector3d centre = cloud.bounds().centre();
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = (cloud.point(i) - centre).cast<float>();
    return offsets;
}

/// Mean spacing of points on the surface, and how thick its flattest parts are, metres.
struct Grain {
    double spacing_m = 0;
    double thickness_m = 0;
};

Grain grainOf(const PointCloud& cloud, double scale, double cell_m) {
    Grain grain;
    const double diagonal = cloud.bounds().diagonal();
    if (!(diagonal > 0)) return grain;
    const std::vector<Eigen::Vector3f> offsets = offsetsOf(cloud);
    const double wide = diagonal / kCellsPerDiagonal;
    const auto cells = static_cast<double>(gatherPoints(offsets, VoxelGrid(wide)).size());
    grain.spacing_m = scale * wide * std::sqrt(cells / static_cast<double>(cloud.size()));
    grain.thickness_m = scale * surfaceThickness(gatherPoints(offsets, VoxelGrid(cell_m / scale)));
    return grain;
}

}  // namespace

double searchVoxel(const PointCloud& target, const PointCloud& source, double scale, double sourceRadius_m) {
    const double wanted = sourceRadius_m / kVoxelsPerRadius;
    double voxel = wanted;
    const Grain there = grainOf(target, 1, 4 * wanted);
    const Grain here = grainOf(source, scale, 4 * wanted);
    voxel = std::max({voxel, kSpacings * there.spacing_m, kThicknesses * there.thickness_m});
    return std::min(std::max({voxel, kSpacings * here.spacing_m, kThicknesses * here.thickness_m}),
                    4 * wanted);
}

bool plausibleExtent(double source_m, double target_m) {
    constexpr double kMostTimes = 20;
    constexpr double kLeastShare = 1.0 / 200;
    return source_m < kMostTimes * target_m && source_m > kLeastShare * target_m;
}

}  // namespace vestige
