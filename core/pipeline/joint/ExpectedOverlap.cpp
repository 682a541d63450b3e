#include "core/pipeline/joint/ExpectedOverlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kMostPoints = 1 << 20;
constexpr double kVoxelsPerExtent = 24;

using Cell = std::array<std::int32_t, 3>;

/// The occupied voxels of a grid at `origin`, sorted.
std::vector<Cell> occupied(const PointCloud& cloud, const Similarity& sceneFromCloud,
                           const Eigen::Vector3d& origin, double edge_m) {
    const std::size_t stride = 1 + (cloud.size() - 1) / kMostPoints;
    std::vector<Cell> cells((cloud.size() + stride - 1) / stride);
    parallelFor(cells.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d x = (sceneFromCloud * cloud.point(i * stride) - origin) / edge_m;
            for (int axis = 0; axis < 3; ++axis)
                cells[i][static_cast<std::size_t>(axis)] =
                    static_cast<std::int32_t>(std::clamp(std::floor(x[axis]), -1e9, 1e9));
        }
    });
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

double shareNear(const std::vector<Cell>& cells, const std::vector<Cell>& others) {
    const auto isNear = [&](const Cell& cell) {
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy) {
                const Cell first{cell[0] + dx, cell[1] + dy, cell[2] - 1};
                const auto found = std::lower_bound(others.begin(), others.end(), first);
                if (found != others.end() && (*found)[0] == first[0] && (*found)[1] == first[1] &&
                    (*found)[2] <= cell[2] + 1)
                    return true;
            }
        return false;
    };
    const auto count = std::count_if(cells.begin(), cells.end(), isNear);
    return static_cast<double>(count) / static_cast<double>(cells.size());
}

}  // namespace

double expectedOverlap(const PointCloud& a, const Similarity& sceneFromA, const PointCloud& b,
                       const Similarity& sceneFromB) {
    if (a.empty() || b.empty()) return 0;
    const double extent =
        std::min(sceneFromA.scale * a.bounds().diagonal(), sceneFromB.scale * b.bounds().diagonal());
    if (!(extent > 0)) return 0;
    const double edge_m = extent / kVoxelsPerExtent;
    const Eigen::Vector3d origin = sceneFromA * a.bounds().centre();
    const auto ofA = occupied(a, sceneFromA, origin, edge_m);
    const auto ofB = occupied(b, sceneFromB, origin, edge_m);
    return std::max(shareNear(ofA, ofB), shareNear(ofB, ofA));
}

}  // namespace vestige
