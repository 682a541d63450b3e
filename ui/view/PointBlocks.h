#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// Neighbouring points that are drawn or left out together. Any number of its first points is spread evenly
/// over the block, so drawing fewer thins it without holes.
struct PointBlock {
    Eigen::Vector3f min;  ///< display frame
    Eigen::Vector3f max;
    std::uint32_t begin;  ///< range in the order of drawing
    std::uint32_t end;
    std::uint32_t size() const { return end - begin; }
};

/// The points of a cloud in the order of drawing: blocks of 65 536 along the Morton curve, each block's
/// points by bit-reversed rank.
struct PointBlocks {
    std::vector<std::uint32_t> order;        ///< index into the cloud
    std::vector<Eigen::Vector3f> positions;  ///< in that order, display frame, metres
    std::vector<PointBlock> blocks;
    double spacing_m = 0;  ///< typical distance of neighbours
};

/// `morton` is an octree's order() or empty (it is then computed). The display frame's origin is
/// `displayOrigin` (world); subtracted in double, so that UTM coordinates keep their digits.
PointBlocks makePointBlocks(const PointCloud& cloud, const Similarity& worldFromLayer,
                            const Eigen::Vector3d& displayOrigin, std::span<const std::uint32_t> morton = {});

}  // namespace vestige
