#include "core/simulation/PointThinning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vestige {

std::vector<std::uint32_t> firstPerCell(const std::vector<Eigen::Vector3f>& points, double spacing) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    keyed.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto cell = static_cast<std::int64_t>(std::floor(points[i][axis] / spacing));
            key = (key << 21) | (static_cast<std::uint64_t>(cell) & 0x1fffff);
        }
        keyed.emplace_back(key, i);
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < keyed.size(); ++i)
        if (i == 0 || keyed[i].first != keyed[i - 1].first) kept.push_back(keyed[i].second);
    std::sort(kept.begin(), kept.end());
    return kept;
}

}  // namespace vestige
