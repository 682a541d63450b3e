#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// One spatial index of a cloud for picking, drawing and neighbours: the points in Morton order of their
/// offsets, and the boxes over them. Immutable; many threads may ask at once. Every answer is in a fixed
/// order, whatever built it. Distances and positions are in the cloud's own unit and frame (offsets round its
/// origin).
class Octree {
  public:
    struct Neighbour {
        std::uint32_t point;  ///< index into the cloud
        float squaredDistance;
    };
    struct Node {
        Eigen::Vector3f min = Eigen::Vector3f::Zero();  ///< offsets
        Eigen::Vector3f max = Eigen::Vector3f::Zero();
        std::uint32_t begin = 0;  ///< range in order()
        std::uint32_t end = 0;
        std::uint32_t firstChild = 0;  ///< index into nodes(); 0 for a leaf
        std::uint8_t childCount = 0;
    };

    /// `cloud` has fewer than 2^32 points; a leaf has at most `leafSize` of them, but for points closer
    /// together than 2^-42 of the cloud's longest side.
    explicit Octree(std::shared_ptr<const PointCloud> cloud, std::uint32_t leafSize = 32);

    const PointCloud& cloud() const { return *cloud_; }
    /// Point indices in Morton order; a node's points are consecutive here.
    std::span<const std::uint32_t> order() const { return order_; }
    /// nodes()[0] is the root; empty for an empty cloud.
    std::span<const Node> nodes() const { return nodes_; }

    /// All points within `radius` of the offset `centre` (squared distance in float at most the square of
    /// `radius`), by ascending index.
    void radiusSearch(const Eigen::Vector3f& centre, float radius, std::vector<Neighbour>& found) const;
    /// The `count` nearest points, nearest first, ties by index.
    void nearest(const Eigen::Vector3f& centre, std::size_t count, std::vector<Neighbour>& found) const;

    /// The spacing of points round this one, which picking and uncertainty use: the mean distance to its 8
    /// nearest neighbours divided by (1 + sqrt 2) / 2. On an even square sampling of a surface (4 neighbours
    /// at d, 4 at sqrt 2 d) that is exactly d; on a random one of density rho it is 0.92 / sqrt rho on
    /// average (mean of Gamma(k + 1/2) / (Gamma(k) sqrt(pi rho)), k = 1 ... 8). Of the neighbours there are
    /// in a cloud of fewer than 9 points; 0 for a single point.
    float localSpacing(std::uint32_t point) const;

    /// `count` indices spread evenly through space (every k-th in Morton order), for coarse drawing.
    std::vector<std::uint32_t> coarse(std::size_t count) const;

  private:
    void build(std::uint32_t leafSize);
    void fillBoxes();

    std::shared_ptr<const PointCloud> cloud_;
    LargeArray<std::uint32_t> order_;
    LargeArray<Node> nodes_;
};

}  // namespace vestige
