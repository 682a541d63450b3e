#pragma once

#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/registration/adjustment/AdjustPoses.h"
#include "core/registration/adjustment/PoseGraph.h"

namespace vestige {

struct AdjustmentOptions {
    /// Probability with which a right edge, or a right set of edges, is taken for a wrong one.
    double falseAlarm = 0.001;
    /// An edge that is nearer than both to where the others put it is no wrong one; its covariance is too
    /// small.
    double leastWrong_m = 0;
    double leastWrong_rad = 0;
};

/// What became of one edge.
struct AdjustedEdge {
    bool used = false;
    std::string whyNot;                    ///< for an edge that is not used, in plain words
    Vector6d residual = Vector6d::Zero();  ///< edgeResidual() at the adjusted poses
    /// By how much the sum of squares falls when the edge is left out (chi-square of 6 degrees of freedom
    /// where the covariances are true); 0 for an edge that alone holds a node.
    double chiSquare = 0;
    bool controlled = false;  ///< other edges say the same thing
};

/// A closed way along the edges: the surest tree, closed by one more edge.
struct LoopError {
    std::size_t closing = 0;              ///< edge
    std::vector<std::size_t> nodes;       ///< in order, from the closing edge's `to` to its `from`
    std::vector<std::size_t> edges;       ///< between them, the closing one last
    Vector6d closure = Vector6d::Zero();  ///< edgeResidual() of the closing edge along the others
    double translation_m = 0;
    double rotation_rad = 0;
    double chiSquare = 0;    ///< closure against the sum of the edges' covariances, 6 degrees of freedom
    double probability = 1;  ///< of a closure as bad as that where the covariances are true
};

/// All poses of a graph, adjusted together.
struct AdjustedGraph {
    FittedPoses fit;                                     ///< its covariances scaled, see varianceFactor
    std::vector<std::optional<ChainedPose>> unadjusted;  ///< along the surest tree of the edges used
    std::vector<AdjustedEdge> edges;
    std::vector<LoopError> loops;  ///< the independent ones, those that rejected edges close among them
    double varianceFactor = 1;     ///< sum of squares by degrees of freedom; 1 without redundancy
    /// Chi-square test of the whole: false when the edges disagree by more than their covariances allow. The
    /// covariances of `fit` are then those of the edges times varianceFactor.
    bool consistent = true;
    std::vector<std::size_t> suspects;  ///< edges of which one is wrong, where nothing tells which
};

/// Leaves out edges that the others prove wrong: while the whole fails the chi-square test, the edge, or else
/// the two, without which the sum of squares is least, if it falls significantly (chi-square, or F test where
/// the others agree less well than they say; data snooping: Baarda 1968, Pope 1976) and significantly further
/// than without any other. Then fits the rest. Edges that `allowed` does not mark (all, where it is empty)
/// take no part. Two wrong edges are looked for among the 24 that matter most one by one. Throws
/// ErrorException when the job is cancelled.
AdjustedGraph adjustGraph(const PoseGraph& graph, const AdjustmentOptions& options = {},
                          const std::vector<bool>& allowed = {}, const JobControl& control = {});

}  // namespace vestige
