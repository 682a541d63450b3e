#include "core/registration/adjustment/PoseGraph.h"

#include <numbers>

#include <gtest/gtest.h>
#include "core/registration/adjustment/RotationVector.h"
#include "tests/core/registration/adjustment/GraphExamples.h"

namespace vestige {
namespace {

using test::randomPose;
using test::randomUncertainty;

const Eigen::Vector3d kUtm(483400, 4375661, 34);

TEST(RotationVector, ExpAndLogAreInverse) {
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
        axis.normalize();
        const double angle = trial < 10 ? 1e-9 * trial : random.uniform(0, std::numbers::pi - 1e-6);
        const Eigen::Vector3d w = angle * axis;
        EXPECT_LT((rotationLog(rotationExp(w)) - w).norm(), 1e-9) << angle;
    }
    EXPECT_NEAR(rotationLog(rotationExp({0, 0, std::numbers::pi})).norm(), std::numbers::pi, 1e-12);
}

TEST(RotationVector, LeftJacobianTellsWhatASmallTurnDoes) {
    Random random(4);
    for (int trial = 0; trial < 50; ++trial) {
        const double size = trial < 10 ? 1e-4 : 1.0;
        const Eigen::Vector3d w = size * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        if (w.norm() > 3) continue;
        constexpr double kStep = 1e-6;
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d d = kStep * Eigen::Vector3d::Unit(axis);
            const Eigen::Vector3d slope = (rotationLog(rotationExp(d) * rotationExp(w)) -
                                           rotationLog(rotationExp(-d) * rotationExp(w))) /
                                          (2 * kStep);
            EXPECT_LT((slope - inverseLeftJacobian(w).col(axis)).norm(), 1e-6);
        }
    }
}

/// The residual's definition: it moves the measured pose onto the one that the two poses have.
TEST(EdgeResidual, MovesTheMeasuredPoseOntoTheOneOfThePoses) {
    Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        const Pose to = randomPose(random, 10);
        const Pose from = randomPose(random, 10);
        const Eigen::Vector3d pivot(1, 2, 3);
        const PoseEdge edge{0, 1, randomPose(random, 5), randomUncertainty(random, 0.01, 0.01, pivot)};
        const Vector6d r = edgeResidual(edge, to, from, {0, 0, 0}, {0, 0, 0}).value;
        for (int i = 0; i < 5; ++i) {
            const Eigen::Vector3d x(random.normal(), random.normal(), random.normal());
            const Eigen::Vector3d expected = to.inverse() * (from * x);
            const Eigen::Vector3d got =
                rotationExp(r.tail<3>()) * (edge.toFromFrom * x - pivot) + pivot + r.head<3>();
            EXPECT_LT((got - expected).norm(), 1e-12);
        }
    }
}

TEST(EdgeResidual, JacobiansAgreeWithFiniteDifferences) {
    Random random(6);
    for (int trial = 0; trial < 20; ++trial) {
        const Pose to = randomPose(random, 5);
        const Pose from = randomPose(random, 5);
        const Eigen::Vector3d pTo(0.5, -1, 2), pFrom(-2, 0.3, 1);
        // A residual of decimetres and tenths of a radian, so that its own turn counts.
        const Pose off(Eigen::Translation3d(0.1, 0.2, -0.1) *
                       Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2) / 3));
        const PoseEdge edge{0, 1, off * to.inverse() * from, randomUncertainty(random, 1, 1, {1, 0, -1})};
        const EdgeResidual residual = edgeResidual(edge, to, from, pTo, pFrom);
        constexpr double kStep = 1e-6;
        for (int k = 0; k < 6; ++k) {
            const Vector6d d = kStep * Vector6d::Unit(k);
            const Vector6d byTo = (edgeResidual(edge, moved(to, d, pTo), from, pTo, pFrom).value -
                                   edgeResidual(edge, moved(to, -d, pTo), from, pTo, pFrom).value) /
                                  (2 * kStep);
            const Vector6d byFrom = (edgeResidual(edge, to, moved(from, d, pFrom), pTo, pFrom).value -
                                     edgeResidual(edge, to, moved(from, -d, pFrom), pTo, pFrom).value) /
                                    (2 * kStep);
            EXPECT_LT((byTo - residual.byTo.col(k)).norm(), 1e-7) << k;
            EXPECT_LT((byFrom - residual.byFrom.col(k)).norm(), 1e-7) << k;
        }
    }
}

TEST(SurestTree, TakesTheWayWithTheLeastVarianceAndTellsWhatItDoesNotReach) {
    PoseGraph graph;
    graph.nodes.assign(5, {});
    graph.nodes[0].fixed = true;
    const auto edge = [&](std::size_t to, std::size_t from, double variance) {
        graph.edges.push_back({to, from, Pose::Identity(), {variance * Matrix6d::Identity(), {0, 0, 0}}});
    };
    edge(0, 1, 1);
    edge(0, 2, 9);
    edge(2, 1, 2);  // round 1 it is 3, straight 9
    edge(3, 4, 1);  // an island
    const auto tree = surestTree(graph, {true, true, true, true});
    ASSERT_EQ(tree.size(), 2u);
    EXPECT_EQ(tree[1].node, 2u);
    EXPECT_EQ(tree[1].before, 1u);
    EXPECT_EQ(tree[1].edge, 2u);
    EXPECT_EQ(surestTree(graph, {true, true, false, true})[1].edge, 1u);
}

/// Closed forms: the variances of a straight chain add, and a turn at its start moves its end by the arm.
TEST(ChainedPoses, AddTheCovariancesOfTheirEdges) {
    PoseGraph graph;
    for (int i = 0; i < 3; ++i) graph.nodes.push_back({i == 0, Pose::Identity(), {0, 0, 0}});
    Matrix6d covariance = Matrix6d::Zero();
    covariance.diagonal() << 1e-6, 4e-6, 9e-6, 1e-8, 1e-8, 4e-8;
    const Pose metreOn(Eigen::Translation3d(1, 0, 0));
    graph.edges.push_back({0, 1, metreOn, {covariance, {1, 0, 0}}});
    graph.edges.push_back({2, 1, metreOn.inverse(), {covariance, {-1, 0, 0}}});  // from the other side
    const auto poses = posesAlong(graph, surestTree(graph, {true, true}));
    ASSERT_TRUE(poses[2]);
    EXPECT_LT((poses[2]->pose.translation() - Eigen::Vector3d(2, 0, 0)).norm(), 1e-15);
    // Both edges are known about node 1, a metre before node 2.
    const Eigen::Vector3d variances = poses[2]->uncertainty.at({2, 0, 0}).diagonal();
    EXPECT_NEAR(variances.x(), 2e-6, 1e-18);
    EXPECT_NEAR(variances.y(), 2 * (4e-6 + 4e-8), 1e-18);
    EXPECT_NEAR(variances.z(), 2 * (9e-6 + 1e-8), 1e-18);
    EXPECT_NEAR(poses[2]->uncertainty.covariance(5, 5), 8e-8, 1e-20);
}

/// 4000 chains drawn from the edges' covariances spread as the chain says, far from the world's origin.
TEST(ChainedPoses, SpreadAsTheySay) {
    Random random(8);
    test::SimulatedGraph simulated(random, 4, {{0, 1}, {2, 1}, {2, 3}}, kUtm, 0.004, 0.002);
    const std::vector<bool> all(3, true);
    Matrix6d spread = Matrix6d::Zero();
    Matrix6d claimed = Matrix6d::Zero();
    constexpr int kTrials = 4000;
    for (int trial = 0; trial < kTrials; ++trial) {
        simulated.measure(random);
        const auto poses = posesAlong(simulated.graph, surestTree(simulated.graph, all));
        const Pose& truth = simulated.truth[3];
        const PoseEdge asMeasured{0, 1, poses[3]->pose, poses[3]->uncertainty};
        const Vector6d error = edgeResidual(asMeasured, Pose::Identity(), truth, {0, 0, 0}, {0, 0, 0}).value;
        spread += error * error.transpose() / kTrials;
        claimed += poses[3]->uncertainty.covariance / kTrials;
    }
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            EXPECT_NEAR(spread(i, j) / std::sqrt(claimed(i, i) * claimed(j, j)),
                        claimed(i, j) / std::sqrt(claimed(i, i) * claimed(j, j)), 0.08)
                << i << " " << j;
}

}  // namespace
}  // namespace vestige
