#include "core/geometry/NeighbourIndex.h"

#include <algorithm>
#include <limits>

#include "core/base/Parallel.h"
#include "core/geometry/LeafScan.h"
#include "core/geometry/MortonGrid.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 512;
/// Below the infinity that fills a leaf.
constexpr float kAnyDistance = std::numeric_limits<float>::max();

FloatBox pointBox(const Eigen::Vector3f& point) {
    return {point, point};
}

}  // namespace

NeighbourIndex::NeighbourIndex(std::span<const Eigen::Vector3f> points) {
    if (points.empty()) return;
    const MortonGrid grid(points);
    const auto sorted = sortedByKey<std::uint64_t>(points.size(), 3 * MortonGrid::kLevels,
                                                   [&](std::size_t begin, std::span<std::uint64_t> keys) {
                                                       for (std::size_t i = 0; i < keys.size(); ++i)
                                                           keys[i] = grid.code(points[begin + i]);
                                                   });
    order_.resize(points.size());
    leaves_.resize((points.size() + kLeaf - 1) / kLeaf);
    boxes_.resize(leaves_.size());
    parallelFor(leaves_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t leaf = begin; leaf < end; ++leaf) {
            for (auto& axis : leaves_[leaf].axes) axis.fill(std::numeric_limits<float>::infinity());
            for (std::size_t i = 0; i < leafSize(leaf); ++i) {
                const std::uint32_t index = sorted[leaf * kLeaf + i].index;
                const Eigen::Vector3f& point = points[index];
                order_[leaf * kLeaf + i] = index;
                for (int axis = 0; axis < 3; ++axis)
                    leaves_[leaf].axes[static_cast<std::size_t>(axis)][i] = point[axis];
                boxes_[leaf].add(point);
            }
        }
    });
    tree_ = BoxTree(boxes_);
}

std::optional<NeighbourIndex::Neighbour> NeighbourIndex::closest(const Eigen::Vector3f& centre,
                                                                 float withinSquared) const {
    Neighbour best{std::numeric_limits<std::uint32_t>::max(), std::min(withinSquared, kAnyDistance)};
    tree_.nearestFirst(
        pointBox(centre), [&](float squared) { return squared > best.squaredDistance; },
        [&](std::uint32_t leaf, float) {
            scanLeaf(leaves_[leaf], centre, best.squaredDistance, [&](std::size_t place, float squared) {
                const Neighbour candidate{order_[leaf * kLeaf + place], squared};
                if (nearer(candidate, best)) best = candidate;
            });
        });
    if (best.point == std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
    return best;
}

void NeighbourIndex::nearest(const Eigen::Vector3f& centre, std::size_t count,
                             std::vector<Neighbour>& found) const {
    found.clear();
    if (count == 0) return;
    // `found` is a heap whose front is the worst of the nearest so far.
    float limit = kAnyDistance;
    tree_.nearestFirst(
        pointBox(centre), [&](float squared) { return squared > limit; },
        [&](std::uint32_t leaf, float) {
            scanLeaf(leaves_[leaf], centre, limit, [&](std::size_t place, float squared) {
                const Neighbour candidate{order_[leaf * kLeaf + place], squared};
                if (found.size() == count) {
                    if (!nearer(candidate, found.front())) return;
                    std::pop_heap(found.begin(), found.end(), nearer);
                    found.pop_back();
                }
                found.push_back(candidate);
                std::push_heap(found.begin(), found.end(), nearer);
                if (found.size() == count) limit = found.front().squaredDistance;
            });
        });
    std::sort_heap(found.begin(), found.end(), nearer);
}

void NeighbourIndex::within(const Eigen::Vector3f& centre, float squaredRadius,
                            std::vector<Neighbour>& found) const {
    found.clear();
    const float limit = std::min(squaredRadius, kAnyDistance);
    tree_.nearestFirst(
        pointBox(centre), [&](float squared) { return squared > limit; },
        [&](std::uint32_t leaf, float) {
            scanLeaf(leaves_[leaf], centre, limit, [&](std::size_t place, float squared) {
                found.push_back({order_[leaf * kLeaf + place], squared});
            });
        });
}

void NeighbourIndex::radiusSearch(const Eigen::Vector3f& centre, float radius,
                                  std::vector<Neighbour>& found) const {
    within(centre, radius * radius, found);
    std::sort(found.begin(), found.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.point < b.point; });
}

}  // namespace vestige
