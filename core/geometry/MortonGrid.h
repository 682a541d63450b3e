#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace vestige {

/// The cube that holds all offsets of a cloud, cut into 2^21 steps along each side.
class MortonGrid {
  public:
    static constexpr int kLevels = 21;

    /// `offsets` is not empty.
    explicit MortonGrid(std::span<const Eigen::Vector3f> offsets);

    /// The bits of the offset's steps along x, y and z interleaved, x highest: three bits for each of the 21
    /// levels of an octree, the coarsest first.
    std::uint64_t code(const Eigen::Vector3f& offset) const;

    /// Length of the cube's side.
    double side() const { return side_; }

  private:
    Eigen::Vector3d least_;
    double side_ = 0;
    double stepsPerUnit_ = 0;
};

}  // namespace vestige
