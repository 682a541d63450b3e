#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/BoxTree.h"

namespace vestige {

/// Exact neighbours of float offsets, for kernels that ask millions of times: the points along a Morton
/// curve, cut into leaves of 32 that AVX2 handles eight points at a time. Holds copies of the points.
/// Immutable; many threads may ask at once. Coordinates are finite, at most 1e15 in magnitude, fewer than
/// 2^32 - 32 of them. Squared distances are float, (dx dx + dy dy) + dz dz, each operation rounded: the same
/// on every machine. (Octree is for picking and drawing; its answers are the same.)
class NeighbourIndex {
  public:
    static constexpr std::size_t kLeaf = 32;

    struct Neighbour {
        std::uint32_t point;  ///< index into the points given
        float squaredDistance;
        bool operator==(const Neighbour&) const = default;
    };
    /// Ascending distance, ties by index.
    static bool nearer(const Neighbour& a, const Neighbour& b) {
        return a.squaredDistance != b.squaredDistance ? a.squaredDistance < b.squaredDistance
                                                      : a.point < b.point;
    }
    /// Coordinates of a leaf's points; the places that the last leaf leaves over are infinite.
    struct alignas(32) Leaf {
        std::array<std::array<float, kLeaf>, 3> axes;
    };

    explicit NeighbourIndex(std::span<const Eigen::Vector3f> points);

    std::size_t size() const { return order_.size(); }
    /// The points' indices, leaf after leaf; points near each other here lie near each other in space.
    std::span<const std::uint32_t> order() const { return order_; }
    std::span<const Leaf> leaves() const { return leaves_; }
    /// Points of the leaf: kLeaf but for the last.
    std::size_t leafSize(std::size_t leaf) const { return std::min(kLeaf, order_.size() - leaf * kLeaf); }
    const BoxTree& tree() const { return tree_; }
    const FloatBox& box(std::size_t leaf) const { return boxes_[leaf]; }

    /// The nearest point, ties to the lowest index, if its squared distance is at most `withinSquared`.
    std::optional<Neighbour> closest(const Eigen::Vector3f& centre, float withinSquared) const;
    /// The `count` nearest points, nearest first, ties by index.
    void nearest(const Eigen::Vector3f& centre, std::size_t count, std::vector<Neighbour>& found) const;
    /// All points whose squared distance is at most `squaredRadius`, in no useful but a fixed order.
    void within(const Eigen::Vector3f& centre, float squaredRadius, std::vector<Neighbour>& found) const;
    /// All points whose squared distance is at most the square of `radius`, by ascending index.
    void radiusSearch(const Eigen::Vector3f& centre, float radius, std::vector<Neighbour>& found) const;

  private:
    std::vector<std::uint32_t> order_;
    std::vector<Leaf> leaves_;
    std::vector<FloatBox> boxes_;
    BoxTree tree_;
};

}  // namespace vestige
