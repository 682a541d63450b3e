#include "core/registration/OverlapQuality.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {

std::vector<float> surfaceDistances(std::span<const NormalDistributions> surfaces,
                                    const CentredSource& source, const Pose& pose) {
    std::vector<const NormalDistributions*> levels;
    for (std::size_t level = surfaces.size(); level-- > 0;) levels.push_back(&surfaces[level]);
    const PointLanes points(source.points);
    std::vector<float> distances(points.x.size());
    parallelFor(points.count, 1024, [&](std::size_t begin, std::size_t end) {
        surfaceDistancesOf(levels, points, begin, end, pose, distances.data());
    });
    distances.resize(points.count);
    return distances;
}

double typicalDistance(std::vector<float> distances) {
    constexpr double kMedianOfNormal = 0.6744897501960817;
    std::erase_if(distances, [](float distance) { return !std::isfinite(distance); });
    if (distances.empty()) return 0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return static_cast<double>(*middle) / kMedianOfNormal;
}

void setOverlap(RegistrationResult& result, std::span<const NormalDistributions> surfaces,
                const CentredSource& source, const Pose& pose) {
    const std::vector<float> distances = surfaceDistances(surfaces, source, pose);
    const NormalDistributions& cells = surfaces[surfaces.size() > 1 ? surfaces.size() - 2 : 0];
    const NormalCell* const table = cells.table();
    std::vector<char> hit(cells.mask() + std::size_t{1}, 0);
    std::size_t inliers = 0, hits = 0;
    double squares = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const auto distance = static_cast<double>(distances[i]);
        if (!(distance <= result.inlierDistance_m)) continue;
        ++inliers;
        squares += distance * distance;
        const Eigen::Vector3d x = pose * source.points[i].cast<double>();
        const NormalCell* cell = cells.find(x.x(), x.y(), x.z());
        if (cell == nullptr || hit[static_cast<std::size_t>(cell - table)] != 0) continue;
        hit[static_cast<std::size_t>(cell - table)] = 1;
        ++hits;
    }
    const auto share = [](std::size_t part, std::size_t whole) {
        return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    result.overlap = share(inliers, distances.size());
    result.targetOverlap = share(hits, cells.size());
    result.rmse_m = inliers == 0 ? 0 : std::sqrt(squares / static_cast<double>(inliers));
}

}  // namespace vestige
