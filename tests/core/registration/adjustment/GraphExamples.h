#pragma once

#include <vector>

#include "core/base/Random.h"
#include "core/registration/adjustment/PoseGraph.h"

namespace vestige::test {

/// Uniformly any rotation; a translation within `reach` of each axis.
Pose randomPose(Random& random, double reach);
/// A full covariance: standard deviations about `metres` and `radians`, correlated.
PoseUncertainty randomUncertainty(Random& random, double metres, double radians,
                                  const Eigen::Vector3d& pivot);
/// (t, w) with that covariance.
Vector6d drawn(Random& random, const Matrix6d& covariance);

struct EdgeEnds {
    std::size_t to;
    std::size_t from;
};

/// Scans round an origin far from zero, node 0 the fixed target; the edges measured with errors that their
/// covariances tell.
struct SimulatedGraph {
    SimulatedGraph(Random& random, std::size_t nodes, const std::vector<EdgeEnds>& edges,
                   const Eigen::Vector3d& origin, double metres = 0.005, double radians = 0.001);
    /// New errors of all edges.
    void measure(Random& random);

    std::vector<Pose> truth;
    PoseGraph graph;
};

}  // namespace vestige::test
