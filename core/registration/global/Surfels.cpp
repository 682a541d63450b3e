#include "core/registration/global/Surfels.h"

#include <Eigen/Eigenvalues>

#include "core/base/Parallel.h"
#include "core/base/Result.h"
#include "core/filters/VoxelDownsample.h"
#include "core/registration/global/NeighbourCells.h"

namespace vestige {
namespace {

constexpr float kNormalRadius = 2.5F;  // voxels
constexpr std::size_t kNormalNeighbours = 5;

/// Least eigenvalue of the scatter as a share of all: foliage and clutter have no surface.
constexpr float kRoughest = 0.12F;

/// The direction of least extent; zero where the points lie on no surface.
Eigen::Vector3f surfaceNormal(const Eigen::Matrix3f& scatter) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.compute(scatter);
    if (!(solver.eigenvalues()[0] <= kRoughest * scatter.trace())) return Eigen::Vector3f::Zero();
    return solver.eigenvectors().col(0).normalized();
}

}  // namespace

Surfels Surfels::select(const std::vector<std::uint32_t>& indices) const {
    Surfels chosen;
    chosen.voxel_m = voxel_m;
    chosen.origin = origin;
    chosen.points.reserve(indices.size());
    chosen.normals.reserve(indices.size());
    for (const std::uint32_t i : indices) {
        chosen.points.push_back(points[i]);
        chosen.normals.push_back(normals[i]);
    }
    return chosen;
}

Surfels surfelsOf(const PointCloud& cloud, double scale, double voxel_m, const JobControl& control) {
    const auto thinned = downsample(cloud, voxel_m / scale, VoxelRepresentative::centroid, control);
    if (!thinned) throw ErrorException{thinned.error()};
    Surfels all;
    all.voxel_m = voxel_m;
    all.origin = scale * thinned->bounds().centre();
    all.points.resize(thinned->size());
    all.normals.assign(thinned->size(), Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < thinned->size(); ++i)
        all.points[i] = (scale * thinned->point(i) - all.origin).cast<float>();
    const NeighbourCells cells(all.points, kNormalRadius * static_cast<float>(voxel_m));
    cells.forEach([&](std::uint32_t point, std::span<const NeighbourCells::Neighbour> near) {
        if (near.size() < kNormalNeighbours) return;
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
        for (const auto& neighbour : near) {
            const Eigen::Vector3f d = all.points[neighbour.point] - all.points[point];
            sum += d;
            squares += d * d.transpose();
        }
        squares -= sum * sum.transpose() / static_cast<float>(near.size() + 1);
        all.normals[point] = surfaceNormal(squares);
    });
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < all.size(); ++i)
        if (all.normals[i].squaredNorm() > 0.5F) kept.push_back(i);
    return kept.size() == all.size() ? all : all.select(kept);
}

std::vector<std::uint32_t> spreadIndices(std::size_t size, std::size_t count) {
    std::vector<std::uint32_t> indices;
    if (size <= count) {
        for (std::uint32_t i = 0; i < size; ++i) indices.push_back(i);
        return indices;
    }
    for (std::size_t k = 0; k < count; ++k) indices.push_back(static_cast<std::uint32_t>(k * size / count));
    return indices;
}

}  // namespace vestige
