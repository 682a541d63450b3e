#pragma once

#include <immintrin.h>

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace vestige {

/// An axis-parallel box of float offsets; empty as made.
struct FloatBox {
    Eigen::Vector3f min = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Vector3f max = Eigen::Vector3f::Constant(-std::numeric_limits<float>::infinity());

    void add(const Eigen::Vector3f& point) {
        min = min.cwiseMin(point);
        max = max.cwiseMax(point);
    }
    void add(const FloatBox& box) {
        min = min.cwiseMin(box.min);
        max = max.cwiseMax(box.max);
    }
};

/// Boxes over boxes, eight to a node: of a row of leaves, the boxes of leaves 8 i ... 8 i + 7 make node i of
/// the lowest level, and so on up to a single node. A leaf's box is never found farther than a point in it:
/// both go through the same operations, and rounding is monotonous.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const FloatBox> leaves);

    /// Calls visit(leaf, squared distance of its box) for leaves nearest child first, but for those for
    /// whose box, or one above it, farther(squared distance) holds at that time. `query`: a point is a box
    /// with min = max.
    template <class Farther, class Visit>
    void nearestFirst(const FloatBox& query, const Farther& farther, const Visit& visit) const;

    /// Calls visit(leaf, squared distance of its box) for all leaves whose box is nearer than `limit`, in a
    /// fixed order.
    template <class Visit>
    void nearerThan(const FloatBox& query, float limit, const Visit& visit) const;

  private:
    struct alignas(32) Node {
        std::array<std::array<float, 8>, 3> min;
        std::array<std::array<float, 8>, 3> max;
    };
    struct Waiting {
        float squared;
        std::uint32_t level;
        std::uint32_t index;
    };

    static __m256 squaredDistances(const Node& node, const FloatBox& query) {
        __m256 sum{};
#pragma GCC unroll 3
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const __m256 below =
                _mm256_sub_ps(_mm256_load_ps(node.min[a].data()), _mm256_set1_ps(query.max[axis]));
            const __m256 above =
                _mm256_sub_ps(_mm256_set1_ps(query.min[axis]), _mm256_load_ps(node.max[a].data()));
            const __m256 gap = _mm256_max_ps(_mm256_max_ps(below, above), _mm256_setzero_ps());
            const __m256 square = _mm256_mul_ps(gap, gap);
            sum = axis == 0 ? square : _mm256_add_ps(sum, square);
        }
        return sum;
    }

    /// levels_[0] holds the boxes of the leaves, the last level one node.
    std::vector<std::vector<Node>> levels_;
};

template <class Farther, class Visit>
void BoxTree::nearestFirst(const FloatBox& query, const Farther& farther, const Visit& visit) const {
    if (levels_.empty()) return;
    // 32 bits of leaves: at most 11 levels, each leaving 7 behind.
    std::array<Waiting, 96> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, static_cast<std::uint32_t>(levels_.size()), 0};
    while (depth > 0) {
        const Waiting top = stack[--depth];
        if (farther(top.squared)) continue;
        if (top.level == 0) {
            visit(top.index, top.squared);
            continue;
        }
        alignas(32) std::array<float, 8> squared;
        _mm256_store_ps(squared.data(), squaredDistances(levels_[top.level - 1][top.index], query));
        const std::size_t before = depth;
        for (std::uint32_t child = 0; child < 8; ++child) {
            // An empty place in a node is infinitely far.
            if (!(squared[child] < std::numeric_limits<float>::infinity()) || farther(squared[child]))
                continue;
            std::size_t place = depth++;
            for (; place > before && stack[place - 1].squared < squared[child]; --place)
                stack[place] = stack[place - 1];
            stack[place] = {squared[child], top.level - 1, top.index * 8 + child};
        }
    }
}

template <class Visit>
void BoxTree::nearerThan(const FloatBox& query, float limit, const Visit& visit) const {
    if (levels_.empty()) return;
    struct Pending {
        std::uint32_t level;
        std::uint32_t index;
    };
    std::array<Pending, 96> stack;
    std::size_t depth = 0;
    stack[depth++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (depth > 0) {
        const Pending top = stack[--depth];
        const __m256 squared = squaredDistances(levels_[top.level][top.index], query);
        const __m256 nearer = _mm256_cmp_ps(squared, _mm256_set1_ps(limit), _CMP_LT_OQ);
        alignas(32) std::array<float, 8> distances;
        _mm256_store_ps(distances.data(), squared);
        for (auto bits = static_cast<unsigned>(_mm256_movemask_ps(nearer)); bits != 0; bits &= bits - 1) {
            const auto child = static_cast<std::uint32_t>(std::countr_zero(bits));
            if (top.level == 0) {
                visit(top.index * 8 + child, distances[child]);
            } else {
                stack[depth++] = {top.level - 1, top.index * 8 + child};
            }
        }
    }
}

}  // namespace vestige
