#include "core/registration/adjustment/AdjustPoses.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <gtest/gtest.h>
#include "core/registration/adjustment/RotationVector.h"
#include "tests/core/registration/adjustment/GraphExamples.h"

namespace vestige {
namespace {

using test::EdgeEnds;
using test::SimulatedGraph;

const Eigen::Vector3d kUtm(483400, 4375661, 34);
const std::vector<EdgeEnds> kRing{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}, {4, 1}};

std::vector<bool> all(const PoseGraph& graph) {
    return std::vector<bool>(graph.edges.size(), true);
}

/// Scans at the corners of a square, each edge a side, the error of closing in the last one alone.
PoseGraph square(double metres, double radians, const Pose& closing) {
    PoseGraph graph;
    const Eigen::Vector3d corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const auto& corner : corners)
        graph.nodes.push_back({graph.nodes.empty(), Pose(Eigen::Translation3d(corner)), {0, 0, 0}});
    Matrix6d covariance = Matrix6d::Zero();
    covariance.diagonal() << Eigen::Vector3d::Constant(metres * metres),
        Eigen::Vector3d::Constant(radians * radians);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const Pose relative(Eigen::Translation3d(corners[next] - corners[i]));
        // All turns about the middle of the square: there a turn of one edge shifts the others' ends alike.
        const Eigen::Vector3d middle = Eigen::Vector3d(0.5, 0.5, 0) - corners[i];
        graph.edges.push_back({i, next, i == 3 ? closing * relative : relative, {covariance, middle}});
    }
    return graph;
}

Vector6d residual(const PoseGraph& graph, const FittedPoses& fit, std::size_t e) {
    const PoseEdge& edge = graph.edges[e];
    return edgeResidual(edge, *fit.poses[edge.to], *fit.poses[edge.from], {0, 0, 0}, {0, 0, 0}).value;
}

TEST(FitPoses, SharesTheClosureOfALoopOfEqualWeightsEvenly) {
    const PoseGraph graph = square(0.01, 0.001, Pose(Eigen::Translation3d(0.04, -0.02, 0.008)));
    const FittedPoses fit = fitPoses(graph, all(graph));
    EXPECT_TRUE(fit.converged);
    EXPECT_EQ(fit.degrees, 6);
    for (std::size_t e = 0; e < 4; ++e)
        EXPECT_LT((residual(graph, fit, e).head<3>() + Eigen::Vector3d(0.01, -0.005, 0.002)).norm(), 1e-5)
            << e;
    // A quarter of the closure each: 4 (c/4)^2 / s^2.
    const double expected = (0.04 * 0.04 + 0.02 * 0.02 + 0.008 * 0.008) / 4 / 1e-4;
    EXPECT_NEAR(fit.chiSquare, expected, 1e-2 * expected);
}

TEST(FitPoses, SharesATurnEvenly) {
    // A turn about the middle of the square, as the edges have it.
    const Eigen::Translation3d middle(0.5, -0.5, 0);
    const Pose turn = middle * Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()) * middle.inverse();
    const PoseGraph graph = square(0.001, 0.001, turn);
    const FittedPoses fit = fitPoses(graph, all(graph));
    for (std::size_t e = 0; e < 4; ++e) {
        EXPECT_NEAR(residual(graph, fit, e)[5], -0.005, 1e-6) << e;
        EXPECT_LT(residual(graph, fit, e).head<3>().norm(), 1e-5) << e;
    }
}

TEST(FitPoses, LeavesATreeAsItIsWithTheChainsCovariance) {
    Random random(11);
    const SimulatedGraph simulated(random, 4, {{0, 1}, {2, 1}, {2, 3}}, kUtm);
    const auto chained = posesAlong(simulated.graph, surestTree(simulated.graph, {true, true, true}));
    const FittedPoses fit = fitPoses(simulated.graph, {true, true, true});
    EXPECT_EQ(fit.degrees, 0);
    EXPECT_NEAR(fit.chiSquare, 0, 1e-9);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_EQ(fit.poses[i]->matrix(), chained[i]->pose.matrix());
        const Matrix6d& expected = chained[i]->uncertainty.covariance;
        EXPECT_LT((fit.uncertainty[i]->covariance - expected).norm(), 1e-6 * expected.norm());
    }
}

TEST(FitPoses, SaysWhichNodesAreOutOfReach) {
    Random random(12);
    const SimulatedGraph simulated(random, 4, {{0, 1}, {2, 3}}, kUtm);
    const FittedPoses fit = fitPoses(simulated.graph, {true, true});
    EXPECT_TRUE(fit.poses[1]);
    EXPECT_FALSE(fit.poses[2]);
    EXPECT_FALSE(fit.poses[3]);
}

/// The same problem by another way: poses as translation and absolute rotation vector, derivatives by
/// differences, whitened residuals in one tall matrix, QR.
TEST(FitPoses, AgreesWithDenseLeastSquaresOfAnotherMake) {
    Random random(13);
    const SimulatedGraph simulated(random, 5, kRing, {0, 0, 0}, 0.02, 0.01);
    const PoseGraph& graph = simulated.graph;
    const auto poseOf = [&](const Eigen::VectorXd& x, std::size_t node) -> Pose {
        if (node == 0) return graph.nodes[0].pose;
        const Vector6d part = x.segment<6>(static_cast<Eigen::Index>(6 * (node - 1)));
        Pose pose = Pose::Identity();
        pose.translation() = part.head<3>();
        pose.linear() =
            Eigen::AngleAxisd(part.tail<3>().norm(), part.tail<3>().normalized()).toRotationMatrix();
        return pose;
    };
    const auto whitened = [&](const Eigen::VectorXd& x) {
        Eigen::VectorXd r(6 * graph.edges.size());
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const PoseEdge& edge = graph.edges[e];
            const Pose relative = poseOf(x, edge.to).inverse() * poseOf(x, edge.from);
            const Pose error = relative * edge.toFromFrom.inverse();
            const Eigen::AngleAxisd turn(error.linear());
            Vector6d one;
            one << error * edge.uncertainty.pivot_m - edge.uncertainty.pivot_m, turn.angle() * turn.axis();
            r.segment<6>(static_cast<Eigen::Index>(6 * e)) =
                edge.uncertainty.covariance.llt().matrixL().solve(one);
        }
        return r;
    };
    Eigen::VectorXd x(24);
    for (std::size_t node = 1; node < 5; ++node) {
        const Eigen::AngleAxisd turn(simulated.truth[node].linear());
        x.segment<6>(static_cast<Eigen::Index>(6 * (node - 1))) << simulated.truth[node].translation(),
            turn.angle() * turn.axis();
    }
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Eigen::VectorXd r = whitened(x);
        Eigen::MatrixXd jacobian(r.size(), x.size());
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            const Eigen::VectorXd d = 1e-6 * Eigen::VectorXd::Unit(x.size(), k);
            jacobian.col(k) = (whitened(x + d) - whitened(x - d)) / 2e-6;
        }
        x -= jacobian.colPivHouseholderQr().solve(r);
    }
    const FittedPoses fit = fitPoses(graph, all(graph));
    EXPECT_NEAR(fit.chiSquare, whitened(x).squaredNorm(), 1e-8);
    for (std::size_t node = 1; node < 5; ++node)
        EXPECT_LT((fit.poses[node]->matrix() - poseOf(x, node).matrix()).norm(), 1e-7) << node;
}

/// The spread of 600 adjustments is what their covariances say, and the sum of squares has its mean.
TEST(FitPoses, TellsItsOwnSpread) {
    Random random(14);
    SimulatedGraph simulated(random, 5, kRing, kUtm, 0.004, 0.002);
    constexpr int kTrials = 600;
    double normalised = 0;
    double chiSquare = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        simulated.measure(random);
        const FittedPoses fit = fitPoses(simulated.graph, all(simulated.graph));
        ASSERT_TRUE(fit.converged);
        chiSquare += fit.chiSquare / kTrials;
        for (std::size_t i = 1; i < 5; ++i) {
            const PoseEdge found{0, i, *fit.poses[i], *fit.uncertainty[i]};
            const Vector6d error =
                edgeResidual(found, Pose::Identity(), simulated.truth[i], {0, 0, 0}, {0, 0, 0}).value;
            normalised += error.dot(fit.uncertainty[i]->covariance.ldlt().solve(error)) / (4 * kTrials);
        }
    }
    EXPECT_NEAR(normalised, 6, 0.3);
    EXPECT_NEAR(chiSquare, 12, 0.8);
}

/// Adjusted poses are nearer to the truth than the best chain.
TEST(FitPoses, IsNearerToTheTruthThanTheChain) {
    Random random(15);
    SimulatedGraph simulated(random, 5, kRing, kUtm);
    double adjusted = 0;
    double chained = 0;
    for (int trial = 0; trial < 100; ++trial) {
        simulated.measure(random);
        const FittedPoses fit = fitPoses(simulated.graph, all(simulated.graph));
        const auto chain = posesAlong(simulated.graph, surestTree(simulated.graph, all(simulated.graph)));
        for (std::size_t i = 1; i < 5; ++i) {
            const Eigen::Vector3d& centre = simulated.graph.nodes[i].centre_m;
            const Eigen::Vector3d truth = simulated.truth[i] * centre;
            adjusted += (*fit.poses[i] * centre - truth).squaredNorm();
            chained += (chain[i]->pose * centre - truth).squaredNorm();
        }
    }
    EXPECT_LT(adjusted, 0.8 * chained);
}

}  // namespace
}  // namespace vestige
