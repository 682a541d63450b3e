#pragma once

#include <optional>
#include <vector>

#include "core/geometry/BoundingBox.h"
#include "core/io/formats/LasSource.h"

namespace vestige {

/// A node of a COPC file's octree: one LAZ chunk of points.
struct CopcNode {
    int level = 0;
    BoundingBox box;
    LasRange points;  ///< in the order of the file
};

/// The octree of a COPC 1.0 file (copc.io), its nodes in the order of their points; nothing where the file is
/// plain LAZ, or where its hierarchy does not agree with its points (it is then read as plain LAZ, with a
/// warning).
std::optional<std::vector<CopcNode>> copcNodes(std::span<const std::byte> file, const LasHeader& header,
                                               ReadJob& job);

/// The points of the nodes that a box touches, neighbouring ranges joined.
std::vector<LasRange> rangesTouching(const std::vector<CopcNode>& nodes, const BoundingBox& box);

/// The points of the first levels, as many levels as hold at most `points` (the first always).
std::vector<LasRange> coarseRanges(const std::vector<CopcNode>& nodes, std::uint64_t points);

}  // namespace vestige
