#include "tests/core/registration/adjustment/GraphExamples.h"

#include <Eigen/Cholesky>

#include "core/registration/adjustment/RotationVector.h"

namespace vestige::test {

Pose randomPose(Random& random, double reach) {
    Eigen::Quaterniond turn(random.normal(), random.normal(), random.normal(), random.normal());
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    for (double& c : pose.translation()) c = random.uniform(-reach, reach);
    return pose;
}

PoseUncertainty randomUncertainty(Random& random, double metres, double radians,
                                  const Eigen::Vector3d& pivot) {
    Matrix6d mix;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            mix(i, j) =
                (i < 3 ? metres : radians) * (i == j ? random.uniform(0.5, 1.5) : 0.3 * random.normal());
    return {mix * mix.transpose(), pivot};
}

Vector6d drawn(Random& random, const Matrix6d& covariance) {
    Vector6d unit;
    for (double& c : unit) c = random.normal();
    return covariance.llt().matrixL() * unit;
}

SimulatedGraph::SimulatedGraph(Random& random, std::size_t nodes, const std::vector<EdgeEnds>& edges,
                               const Eigen::Vector3d& origin, double metres, double radians) {
    for (std::size_t i = 0; i < nodes; ++i) {
        Pose pose = i == 0 ? Pose::Identity() : randomPose(random, 3);
        if (i > 0) pose.translation() += origin;
        truth.push_back(pose);
        const Eigen::Vector3d centre = i == 0 ? origin : Eigen::Vector3d(0.4, -0.2, 0.1);
        graph.nodes.push_back({i == 0, pose, centre});
    }
    for (const EdgeEnds& ends : edges) {
        const Pose relative = truth[ends.to].inverse() * truth[ends.from];
        const Eigen::Vector3d pivot = relative * graph.nodes[ends.from].centre_m;
        graph.edges.push_back(
            {ends.to, ends.from, relative, randomUncertainty(random, metres, radians, pivot)});
    }
    measure(random);
}

void SimulatedGraph::measure(Random& random) {
    for (PoseEdge& edge : graph.edges) {
        // The true pose is the measured one moved by an error of the covariance, so the measured is the true
        // one moved back.
        const Pose relative = truth[edge.to].inverse() * truth[edge.from];
        const Vector6d error = drawn(random, edge.uncertainty.covariance);
        Pose back = Pose::Identity();
        back.linear() = rotationExp(-error.tail<3>());
        const Eigen::Vector3d& pivot = edge.uncertainty.pivot_m;
        back.translation() = back.linear() * -(pivot + error.head<3>()) + pivot;
        edge.toFromFrom = back * relative;
    }
}

}  // namespace vestige::test
