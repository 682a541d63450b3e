#include "core/registration/Grain.h"

#include <cmath>
#include <vector>

#include "core/registration/ndt/CellMoments.h"
#include "core/registration/ndt/NormalDistributions.h"

namespace vestige {
namespace {

constexpr double kCellsPerDiagonal = 64;

std::vector<Eigen::Vector3f> offsetsOf(const PointCloud& cloud) {
    std::vector<Eigen::Vector3f> offsets(cloud.size());
    const Eigen::Vector3d centre = cloud.bounds().centre();
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = (cloud.point(i) - centre).cast<float>();
    return offsets;
}

}  // namespace

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

}  // namespace vestige
