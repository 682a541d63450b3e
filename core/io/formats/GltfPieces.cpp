#include "core/io/formats/GltfPieces.h"

#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

namespace vestige {
namespace {

constexpr double kReach = 1024;

using Cell = std::array<double, 3>;

Cell cellOf(const Eigen::Vector3d& point) {
    return {std::floor(point.x() / kReach), std::floor(point.y() / kReach), std::floor(point.z() / kReach)};
}

}  // namespace

std::vector<GltfPiece> gltfPieces(const TriangleMesh& mesh) {
    const PointCloud& cloud = mesh.vertices;
    std::vector<GltfPiece> pieces;
    if (cloud.empty()) return pieces;
    if (cloud.bounds().extent().maxCoeff() <= 2 * kReach - 2) {
        pieces.emplace_back().everything = true;
        pieces.back().origin = cloud.bounds().centre().array().round();
        return pieces;
    }
    std::map<Cell, std::size_t> numbers;
    std::vector<std::uint32_t> pieceOf(cloud.size()), placeIn(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Cell cell = cellOf(cloud.point(i));
        const auto [known, isNew] = numbers.emplace(cell, pieces.size());
        if (isNew)
            pieces.emplace_back().origin =
                kReach * (Eigen::Vector3d(cell.data()) + Eigen::Vector3d::Constant(0.5));
        GltfPiece& piece = pieces[known->second];
        pieceOf[i] = static_cast<std::uint32_t>(known->second);
        placeIn[i] = static_cast<std::uint32_t>(piece.points.size());
        piece.points.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<std::unordered_map<std::uint32_t, std::uint32_t>> repeated(pieces.size());
    for (const Triangle& triangle : mesh.triangles) {
        const std::uint32_t home = pieceOf[triangle[0]];
        GltfPiece& piece = pieces[home];
        Triangle local{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = triangle[k];
            if (pieceOf[vertex] == home) {
                local[k] = placeIn[vertex];
                continue;
            }
            const auto [known, isNew] =
                repeated[home].emplace(vertex, static_cast<std::uint32_t>(piece.points.size()));
            if (isNew) piece.points.push_back(vertex);
            local[k] = known->second;
        }
        piece.triangles.push_back(local);
    }
    return pieces;
}

}  // namespace vestige
