#include "core/registration/icp/SurfaceNormals.h"

#include <Eigen/Eigenvalues>

#include "core/base/Parallel.h"

namespace vestige {

std::vector<Eigen::Vector3f> surfaceNormals(const NeighbourIndex& index,
                                            std::span<const Eigen::Vector3f> points, std::size_t neighbours) {
    std::vector<Eigen::Vector3f> normals(points.size());
    parallelFor(points.size(), 512, [&](std::size_t begin, std::size_t end) {
        std::vector<NeighbourIndex::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            index.nearest(points[i], neighbours, near);
            Eigen::Vector3f mean = Eigen::Vector3f::Zero();
            for (const auto& one : near) mean += points[one.point] - points[i];
            mean /= static_cast<float>(near.size());
            Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
            for (const auto& one : near) {
                const Eigen::Vector3f offset = points[one.point] - points[i] - mean;
                scatter += offset * offset.transpose();
            }
            normals[i] = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(scatter).eigenvectors().col(0);
        }
    });
    return normals;
}

}  // namespace vestige
