#pragma once

#include "core/pipeline/joint/PairLayers.h"
#include "core/registration/adjustment/AdjustGraph.h"

namespace vestige {

/// The pairs that have a result as a graph: a node for each member, `edgePairs` the pair of each edge.
struct LayerGraph {
    PoseGraph graph;
    std::vector<std::size_t> edgePairs;
};
LayerGraph layerGraph(const PairedLayers& paired);

/// All poses of the members from their pairs: results of the layers that are not fixed, and the adjustment
/// where not every layer stands by its own registration to the target. A member that no pair reaches has a
/// failure.
Result<AttemptedLayers> adjustLayers(const SceneState& scene, const PairedLayers& paired,
                                     const JobControl& control);

}  // namespace vestige
