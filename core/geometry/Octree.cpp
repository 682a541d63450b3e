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
using Code = KeyedIndex<std::uint64_t>;

/// Points closer together than this share of the cloud's longest side are not told apart: that is the steps
/// of a grid within a grid's step, and bounds the depth of the tree.
constexpr double kFinest = 1.0 / (std::uint64_t{1} << 2 * kLevels);
/// A node's children replace it on a search's stack: at most 7 more for each level of three grids.
constexpr std::size_t kStack = 8 * 3 * kLevels;
constexpr std::size_t kGrain = 4096;
constexpr std::size_t kSpacingNeighbours = 8;

unsigned octant(std::uint64_t code, int level) {
    return static_cast<unsigned>(code >> (3 * (kLevels - 1 - level))) & 7U;
}

struct PendingChild {
    std::uint32_t begin;
    std::uint32_t end;
};

/// Finds the children of nodes, each a range of the sorted codes; ranges do not overlap, so many threads may
/// ask for their own.
class Divider {
  public:
    Divider(std::span<const Eigen::Vector3f> offsets, std::vector<Code>& sorted, std::uint32_t leafSize,
            double finest)
        : offsets_(offsets), sorted_(sorted), leafSize_(leafSize), finest_(finest) {}

    /// The non-empty children of a range, of the first level of the tree at which it divides. None for a
    /// leaf.
    void divide(std::uint32_t begin, std::uint32_t end, std::vector<PendingChild>& into) {
        if (end - begin <= leafSize_) return;
        if (sorted_[begin].key == sorted_[end - 1].key && !refine(begin, end)) return;
        int level = 0;
        while (octant(sorted_[begin].key, level) == octant(sorted_[end - 1].key, level)) ++level;
        for (std::uint32_t at = begin; at < end;) {
            const unsigned here = octant(sorted_[at].key, level);
            const auto next =
                std::partition_point(sorted_.begin() + at, sorted_.begin() + end,
                                     [&](const Code& code) { return octant(code.key, level) <= here; });
            const auto stop = static_cast<std::uint32_t>(next - sorted_.begin());
            into.push_back({at, stop});
            at = stop;
        }
    }

  private:
    /// A far stray makes the steps of the grid coarse: points that share one step get codes of a grid of
    /// their own. False when they are too close together even for that.
    bool refine(std::uint32_t begin, std::uint32_t end) {
        const std::span<Code> range = std::span(sorted_).subspan(begin, end - begin);
        if (!(longestSide(range) > finest_)) return false;
        std::vector<Eigen::Vector3f> places;
        places.reserve(range.size());
        for (const Code& code : range) places.push_back(offsets_[code.index]);
        const MortonGrid grid(places);
        for (Code& code : range) code.key = grid.code(offsets_[code.index]);
        std::sort(range.begin(), range.end(), [](const Code& a, const Code& b) {
            return a.key != b.key ? a.key < b.key : a.index < b.index;
        });
        return true;
    }

    double longestSide(std::span<const Code> range) const {
        Eigen::Vector3f min = offsets_[range.front().index];
        Eigen::Vector3f max = min;
        for (const Code& code : range) {
            min = min.cwiseMin(offsets_[code.index]);
            max = max.cwiseMax(offsets_[code.index]);
        }
        return (max.cast<double>() - min.cast<double>()).maxCoeff();
    }

    std::span<const Eigen::Vector3f> offsets_;
    std::vector<Code>& sorted_;
    std::uint32_t leafSize_;
    double finest_;
};

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
    const std::span<const Eigen::Vector3f> offsets = cloud_->offsets();
    const MortonGrid grid(offsets);
    std::vector<Code> sorted = sortedByKey<std::uint64_t>(
        offsets.size(), 3 * kLevels, [&](std::size_t begin, std::span<std::uint64_t> keys) {
            for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = grid.code(offsets[begin + i]);
        });
    const auto addNode = [&](std::uint32_t begin, std::uint32_t end) {
        Node& node = nodes_.emplace_back();
        node.begin = begin;
        node.end = end;
    };

    Divider divider(offsets, sorted, leafSize, kFinest * grid.side());
    // Level by level, each level's children found in parallel and appended in order.
    addNode(0, static_cast<std::uint32_t>(sorted.size()));
    for (std::size_t level = 0; level < nodes_.size();) {
        const std::size_t first = level;
        const std::size_t many = nodes_.size() - first;
        std::vector<std::vector<PendingChild>> found((many + kGrain - 1) / kGrain);
        parallelChunks(many, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i) {
                const std::size_t before = found[chunk].size();
                divider.divide(nodes_[i].begin, nodes_[i].end, found[chunk]);
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
    order_.resize(sorted.size());
    parallelFor(sorted.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) order_[i] = sorted[i].index;
    });
}

void Octree::fillBoxes() {
    const std::span<const Eigen::Vector3f> offsets = cloud_->offsets();
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
    std::uint32_t stack[kStack];
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
    Waiting stack[kStack];
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
        // Points that all coincide are in order of their index; those after the first `count` have no chance.
        const std::uint32_t all = node.end - node.begin;
        const auto many =
            node.min == node.max ? static_cast<std::uint32_t>(std::min<std::size_t>(all, count)) : all;
        for (std::uint32_t at = node.begin; at < node.begin + many; ++at) {
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
