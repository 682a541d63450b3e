#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/BoundingBox.h"
#include "core/geometry/Octree.h"

namespace vestige {

/// Neighbouring points that are drawn, thinned or left out together.
struct PointBlock {
    BoundingBox box;          ///< world, where the layer lay when the blocks were made
    std::uint32_t begin = 0;  ///< range in Octree::order()
    std::uint32_t end = 0;
    double spacing_m = 0;  ///< typical distance of neighbours that do not coincide
    std::uint32_t size() const { return end - begin; }
};

/// A cloud in the order of drawing: blocks of 65 536 points along the octree's Morton curve, each block's
/// points by bit-reversed rank, so that any number of its first points is spread evenly over it. Nothing is
/// held per point: rank and index are computed when asked for.
class PointBlocks {
  public:
    static constexpr std::uint32_t kBits = 16;
    static constexpr std::uint32_t kSize = 1U << kBits;

    PointBlocks() = default;
    /// Takes boxes from the octree's nodes and spacings from a sample: milliseconds for any cloud.
    PointBlocks(std::shared_ptr<const Octree> octree, const Similarity& worldFromLayer);

    const std::vector<PointBlock>& blocks() const { return blocks_; }
    /// Typical distance of neighbours that do not coincide in the whole cloud, metres.
    double spacing_m() const { return spacing_m_; }
    /// Index into the cloud of the point that is drawn as number `rank` (below the block's size) of a block.
    std::uint32_t point(std::size_t block, std::uint32_t rank) const;

  private:
    std::shared_ptr<const Octree> octree_;
    std::vector<PointBlock> blocks_;
    std::vector<std::uint16_t> lastRanks_;  ///< of a last block that is not full
    double spacing_m_ = 0;
};

/// How many of a block's first points a picture can show: those that stand half a pixel apart or more where
/// the block is nearest. More hide each other. `metresPerPixel` there, 0 where the camera is in the block.
std::uint32_t pointsWorthDrawing(const PointBlock& block, double metresPerPixel);

}  // namespace vestige
