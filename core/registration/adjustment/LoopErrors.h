#pragma once

#include <vector>

#include "core/registration/adjustment/AdjustGraph.h"

namespace vestige {

/// The independent loops: each edge that `measured` marks and `tree` does not use closes one with the tree's
/// paths to its two nodes. Edges with a node that the tree does not reach close none.
std::vector<LoopError> loopErrors(const PoseGraph& graph, const std::vector<TreeStep>& tree,
                                  const std::vector<bool>& measured);

}  // namespace vestige
