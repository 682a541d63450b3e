#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/geometry/PoseUncertainty.h"

namespace vestige {

/// A frame of the graph: a scan, in metres, and where it lies in the scene.
struct PoseNode {
    bool fixed = false;                 ///< its pose is known and held: the target
    Pose pose = Pose::Identity();       ///< scene from node; of a free node: not read, only found
    Eigen::Vector3d centre_m{0, 0, 0};  ///< node's own frame: where its points are
};

/// A measured relative pose. `uncertainty` is that of toFromFrom in the frame of `to`.
struct PoseEdge {
    std::size_t to = 0;
    std::size_t from = 0;
    Pose toFromFrom = Pose::Identity();
    PoseUncertainty uncertainty;
};

struct PoseGraph {
    std::vector<PoseNode> nodes;
    std::vector<PoseEdge> edges;
};

/// One edge against two poses: r = (t, w) with exp(w)(M x - pivot) + pivot + t the relative pose that the two
/// poses have, M the measured one. Its covariance is the edge's. The Jacobians are with respect to a motion
/// x -> exp(w)(x - p) + p + t of node `to` and of node `from` in the scene, (t, w), at zero; `pTo` and
/// `pFrom` are those p, in the scene.
struct EdgeResidual {
    Vector6d value;
    Matrix6d byTo;
    Matrix6d byFrom;
};
EdgeResidual edgeResidual(const PoseEdge& edge, const Pose& to, const Pose& from, const Eigen::Vector3d& pTo,
                          const Eigen::Vector3d& pFrom);

/// The pose moved by (t, w) as above.
Pose moved(const Pose& pose, const Vector6d& motion, const Eigen::Vector3d& p);

/// The uncertainty of an edge as it shows in the scene, where its `to` node has this pose.
PoseUncertainty inScene(const PoseUncertainty& ofEdge, const Pose& sceneFromTo);

/// How a node is reached from the fixed ones: through one edge from the node before it.
struct TreeStep {
    std::size_t node = 0;
    std::size_t before = 0;
    std::size_t edge = 0;
};

/// The tree of the surest paths from the fixed nodes over the edges that `used` marks, in the order in which
/// the nodes are reached: of all paths to a node the one whose edges' variances (m^2 of the translation, and
/// rad^2 at an arm of 1 m) have the least sum; ties go to the lower number.
std::vector<TreeStep> surestTree(const PoseGraph& graph, const std::vector<bool>& used);

/// The nodes' poses and uncertainties (about their centres, scene) along a tree; nothing for nodes that it
/// does not reach. The uncertainty of a chain is the sum of its edges', carried to the node's centre.
struct ChainedPose {
    Pose pose = Pose::Identity();
    PoseUncertainty uncertainty;
};
std::vector<std::optional<ChainedPose>> posesAlong(const PoseGraph& graph, const std::vector<TreeStep>& tree);

}  // namespace vestige
