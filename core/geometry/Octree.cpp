#include "core/geometry/Octree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/Parallel.h"
#include "core/geometry/MortonGrid.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr int kLevels = MortonGrid::kLevels;
constexpr std::size_t kGrain = 4096;
constexpr std::size_t kSpacingNeighbours = 8;

unsigned octant(std::uint64_t code, int level) {
    return static_cast<unsigned>(code >> (3 * (kLevels - 1 - level))) & 7U;
}

struct PendingChild {
    std::uint32_t begin;
    std::uint32_t end;
};

/// The non-empty children of a range of sorted codes, one level of the tree finer where the range divides.
/// None for a leaf.
void children(const std::vector<KeyedIndex<std::uint64_t>>& sorted, std::uint32_t begin, std::uint32_t end,
              std::uint32_t leafSize, std::vector<PendingChild>& into) {
    if (end - begin <= leafSize || sorted[begin].key == sorted[end - 1].key) return;
    // Levels at which all points share one octant get no node of their own.
    int level = 0;
    while (octant(sorted[begin].key, level) == octant(sorted[end - 1].key, level)) ++level;
    for (std::uint32_t at = begin; at < end;) {
        const unsigned here = octant(sorted[at].key, level);
        const auto next = std::partition_point(
            sorted.begin() + at, sorted.begin() + end,
            [&](const KeyedIndex<std::uint64_t>& entry) { return octant(entry.key, level) <= here; });
        const auto stop = static_cast<std::uint32_t>(next - sorted.begin());
        into.push_back({at, stop});
        at = stop;
    }
}

// Points and boxes go through the same operations in the same order, so a box is never found farther than a
// point in it: rounding is monotonous.
float squared(const Eigen::Vector3f& d) {
    return d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
}
float squaredDistance(const Octree::Node& node, const Eigen::Vector3f& centre) {
    return squared((node.min - centre).cwiseMax(centre - node.max).cwiseMax(0.0F));
}

bool nearer(const Octree::Neighbour& a, const Octree::Neighbour& b) {
    return a.squaredDistance != b.squaredDistance ? a.squaredDistance < b.squaredDistance : a.point < b.point;
}

}  // namespace

Octree::Octree(std::shared_ptr<const PointCloud> cloud, std::uint32_t leafSize) : cloud_(std::move(cloud)) {
    if (cloud_->empty()) return;
    build(std::max<std::uint32_t>(1, leafSize));
    fillBoxes();
}

void Octree::build(std::uint32_t leafSize) {
    const std::vector<Eigen::Vector3f>& offsets = cloud_->offsets();
    const MortonGrid grid(offsets);
    const std::vector<KeyedIndex<std::uint64_t>> sorted = sortedByKey<std::uint64_t>(
        offsets.size(), 3 * kLevels, [&](std::size_t begin, std::span<std::uint64_t> keys) {
            for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = grid.code(offsets[begin + i]);
        });
    order_.resize(sorted.size());
    parallelFor(sorted.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) order_[i] = sorted[i].index;
    });

    const auto addNode = [&](std::uint32_t begin, std::uint32_t end) {
        Node& node = nodes_.emplace_back();
        node.begin = begin;
        node.end = end;
    };

    // Level by level, each level's children found in parallel and appended in order.
    addNode(0, static_cast<std::uint32_t>(sorted.size()));
    for (std::size_t level = 0; level < nodes_.size();) {
        const std::size_t first = level;
        const std::size_t many = nodes_.size() - first;
        std::vector<std::vector<PendingChild>> found((many + kGrain - 1) / kGrain);
        parallelChunks(many, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i) {
                const std::size_t before = found[chunk].size();
                children(sorted, nodes_[i].begin, nodes_[i].end, leafSize, found[chunk]);
                nodes_[i].childCount = static_cast<std::uint8_t>(found[chunk].size() - before);
            }
        });
        level = nodes_.size();
        auto next = static_cast<std::uint32_t>(level);
        for (std::size_t i = first; i < level; ++i) {
            if (nodes_[i].childCount > 0) nodes_[i].firstChild = next;
            next += nodes_[i].childCount;
        }
        for (const auto& chunk : found)
            for (const PendingChild& child : chunk) addNode(child.begin, child.end);
    }
    nodes_.shrink_to_fit();
}

void Octree::fillBoxes() {
    const std::vector<Eigen::Vector3f>& offsets = cloud_->offsets();
    parallelFor(nodes_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Node& node = nodes_[i];
            if (node.childCount > 0) continue;
            node.min = node.max = offsets[order_[node.begin]];
            for (std::uint32_t at = node.begin + 1; at < node.end; ++at) {
                node.min = node.min.cwiseMin(offsets[order_[at]]);
                node.max = node.max.cwiseMax(offsets[order_[at]]);
            }
        }
    });
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.childCount == 0) continue;
        node.min = nodes_[node.firstChild].min;
        node.max = nodes_[node.firstChild].max;
        for (std::uint32_t child = 1; child < node.childCount; ++child) {
            node.min = node.min.cwiseMin(nodes_[node.firstChild + child].min);
            node.max = node.max.cwiseMax(nodes_[node.firstChild + child].max);
        }
    }
}

void Octree::radiusSearch(const Eigen::Vector3f& centre, float radius, std::vector<Neighbour>& found) const {
    found.clear();
    if (nodes_.empty()) return;
    const float limit = radius * radius;
    // A node's children replace it on the stack: at most 7 more for each of 21 levels.
    std::uint32_t stack[8 * kLevels];
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (squaredDistance(node, centre) > limit) continue;
        for (std::uint32_t child = 0; child < node.childCount; ++child)
            stack[depth++] = node.firstChild + child;
        if (node.childCount > 0) continue;
        for (std::uint32_t at = node.begin; at < node.end; ++at) {
            const float distance = squared(cloud_->offsets()[order_[at]] - centre);
            if (distance <= limit) found.push_back({order_[at], distance});
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.point < b.point; });
}

void Octree::nearest(const Eigen::Vector3f& centre, std::size_t count, std::vector<Neighbour>& found) const {
    found.clear();
    if (nodes_.empty() || count == 0) return;
    struct Waiting {
        float distance;
        std::uint32_t node;
    };
    Waiting stack[8 * kLevels];
    std::size_t depth = 0;
    stack[depth++] = {squaredDistance(nodes_[0], centre), 0};
    // `found` is a heap whose front is the worst of the nearest so far.
    while (depth > 0) {
        const Waiting waiting = stack[--depth];
        if (found.size() == count && waiting.distance > found.front().squaredDistance) continue;
        const Node& node = nodes_[waiting.node];
        const std::size_t before = depth;
        for (std::uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) {
            // Farthest first, so that the nearest child is taken from the stack next.
            const Waiting entry{squaredDistance(nodes_[child], centre), child};
            std::size_t place = depth++;
            for (; place > before && stack[place - 1].distance < entry.distance; --place)
                stack[place] = stack[place - 1];
            stack[place] = entry;
        }
        if (node.childCount > 0) continue;
        for (std::uint32_t at = node.begin; at < node.end; ++at) {
            const Neighbour candidate{order_[at], squared(cloud_->offsets()[order_[at]] - centre)};
            if (found.size() == count) {
                if (!nearer(candidate, found.front())) continue;
                std::pop_heap(found.begin(), found.end(), nearer);
                found.pop_back();
            }
            found.push_back(candidate);
            std::push_heap(found.begin(), found.end(), nearer);
        }
    }
    std::sort_heap(found.begin(), found.end(), nearer);
}

float Octree::localSpacing(std::uint32_t point) const {
    std::vector<Neighbour> found;
    nearest(cloud_->offsets()[point], kSpacingNeighbours + 1, found);
    // The point itself, or one that coincides with it, stands for no distance.
    if (found.size() < 2) return 0;
    double sum = 0;
    for (std::size_t i = 1; i < found.size(); ++i)
        sum += std::sqrt(static_cast<double>(found[i].squaredDistance));
    return static_cast<float>(sum / static_cast<double>(found.size() - 1) / (0.5 * (1 + std::sqrt(2.0))));
}

std::vector<std::uint32_t> Octree::coarse(std::size_t count) const {
    count = std::min(count, order_.size());
    std::vector<std::uint32_t> chosen(count);
    for (std::size_t i = 0; i < count; ++i) chosen[i] = order_[i * order_.size() / count];
    return chosen;
}

}  // namespace vestige
