#include "core/registration/adjustment/AdjustGraph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "core/registration/adjustment/SignificanceTests.h"
#include "tests/core/registration/adjustment/GraphExamples.h"

namespace vestige {
namespace {

using test::EdgeEnds;
using test::SimulatedGraph;
using testing::ElementsAre;
using testing::HasSubstr;

const Eigen::Vector3d kUtm(483400, 4375661, 34);
/// Four scans round a car, all but one tied to the target.
const std::vector<EdgeEnds> kRound{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}, {3, 4}, {4, 1}};

Pose shift(double x, double y, double z) {
    return Pose(Eigen::Translation3d(x, y, z));
}

TEST(AdjustGraph, RejectsTheEdgeThatTheOthersContradict) {
    Random random(21);
    for (std::size_t wrong = 0; wrong < 5; ++wrong) {
        SimulatedGraph simulated(random, 5, kRound, kUtm);
        PoseEdge& edge = simulated.graph.edges[wrong];
        const Pose half(Eigen::AngleAxisd(wrong % 2 ? 0.02 : 3.0, Eigen::Vector3d::UnitZ()));
        edge.toFromFrom = edge.toFromFrom * half;
        const AdjustedGraph adjusted = adjustGraph(simulated.graph);
        for (std::size_t e = 0; e < kRound.size(); ++e) EXPECT_EQ(adjusted.edges[e].used, e != wrong) << e;
        EXPECT_THAT(adjusted.edges[wrong].whyNot, HasSubstr("contradict"));
        EXPECT_GT(adjusted.edges[wrong].chiSquare, 50);
        EXPECT_TRUE(adjusted.consistent);
        EXPECT_TRUE(adjusted.suspects.empty());
        for (std::size_t i = 1; i < 5; ++i)
            EXPECT_LT((adjusted.fit.poses[i]->translation() - simulated.truth[i].translation()).norm(), 0.03);
    }
}

TEST(AdjustGraph, RejectsTwoWrongEdges) {
    Random random(22);
    SimulatedGraph simulated(random, 4, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}, {1, 3}}, kUtm);
    for (const std::size_t wrong : {1u, 5u})
        simulated.graph.edges[wrong].toFromFrom =
            shift(0.3, 0.1, 0) * simulated.graph.edges[wrong].toFromFrom;
    const AdjustedGraph adjusted = adjustGraph(simulated.graph);
    EXPECT_FALSE(adjusted.edges[1].used);
    EXPECT_FALSE(adjusted.edges[5].used);
    EXPECT_TRUE(adjusted.edges[0].used && adjusted.edges[2].used && adjusted.edges[3].used &&
                adjusted.edges[4].used);
}

TEST(AdjustGraph, DoesNotGuessWhichEdgeOfALoneLoopIsWrong) {
    Random random(23);
    SimulatedGraph simulated(random, 3, {{0, 1}, {0, 2}, {1, 2}}, kUtm);
    simulated.graph.edges[2].toFromFrom = shift(0.2, 0, 0) * simulated.graph.edges[2].toFromFrom;
    const AdjustedGraph adjusted = adjustGraph(simulated.graph);
    EXPECT_THAT(adjusted.suspects, ElementsAre(0, 1, 2));
    for (const AdjustedEdge& edge : adjusted.edges) EXPECT_TRUE(edge.used);
    EXPECT_FALSE(adjusted.consistent);
    // What is not known is said: the covariances grow with the disagreement.
    const FittedPoses plain = fitPoses(simulated.graph, {true, true, true});
    EXPECT_NEAR(adjusted.fit.uncertainty[1]->covariance(0, 0),
                adjusted.varianceFactor * plain.uncertainty[1]->covariance(0, 0), 1e-12);
    EXPECT_GT(adjusted.varianceFactor, 10);
}

TEST(AdjustGraph, SeldomRejectsARightEdge) {
    Random random(24);
    SimulatedGraph simulated(random, 5, kRound, kUtm);
    int rejected = 0;
    int inconsistent = 0;
    for (int trial = 0; trial < 400; ++trial) {
        simulated.measure(random);
        const AdjustedGraph adjusted = adjustGraph(simulated.graph);
        for (const AdjustedEdge& edge : adjusted.edges) rejected += !edge.used;
        inconsistent += !adjusted.consistent;
    }
    EXPECT_LE(rejected, 2) << "one in a thousand";
    EXPECT_NEAR(inconsistent, 20, 14) << "one in twenty";
}

TEST(AdjustGraph, TellsCovariancesThatAreTooSmallFromAWrongEdge) {
    Random random(25);
    SimulatedGraph simulated(random, 5, kRound, kUtm);
    for (PoseEdge& edge : simulated.graph.edges) edge.uncertainty.covariance /= 25;
    int rejected = 0;
    for (int trial = 0; trial < 50; ++trial) {
        for (PoseEdge& edge : simulated.graph.edges) edge.uncertainty.covariance *= 25;
        simulated.measure(random);
        for (PoseEdge& edge : simulated.graph.edges) edge.uncertainty.covariance /= 25;
        const AdjustedGraph adjusted = adjustGraph(simulated.graph);
        for (const AdjustedEdge& edge : adjusted.edges) rejected += !edge.used;
        EXPECT_FALSE(adjusted.consistent);
        EXPECT_GT(adjusted.varianceFactor, 5);
    }
    EXPECT_LE(rejected, 4);
}

TEST(AdjustGraph, TakesAnEdgeThatIsNearWhereItShouldBeForTooSureNotForWrong) {
    Random random(29);
    SimulatedGraph simulated(random, 5, kRound, kUtm, 0.0005, 0.0001);
    PoseEdge& edge = simulated.graph.edges[3];
    edge.toFromFrom = shift(0.015, 0, 0) * edge.toFromFrom;
    EXPECT_FALSE(adjustGraph(simulated.graph).edges[3].used);
    const AdjustedGraph adjusted = adjustGraph(simulated.graph, {0.001, 0.1, 0.1});
    EXPECT_TRUE(adjusted.edges[3].used);
    EXPECT_FALSE(adjusted.consistent);
    edge.toFromFrom = shift(0.2, 0, 0) * edge.toFromFrom;
    EXPECT_FALSE(adjustGraph(simulated.graph, {0.001, 0.1, 0.1}).edges[3].used);
}

TEST(AdjustGraph, RefusesACovarianceThatIsNone) {
    Random random(26);
    SimulatedGraph simulated(random, 3, {{0, 1}, {0, 2}, {1, 2}}, kUtm);
    simulated.graph.edges[2].uncertainty.covariance.setZero();
    const AdjustedGraph adjusted = adjustGraph(simulated.graph);
    EXPECT_FALSE(adjusted.edges[2].used);
    EXPECT_THAT(adjusted.edges[2].whyNot, HasSubstr("positive definite"));
    EXPECT_TRUE(adjusted.loops.empty());
}

TEST(LoopErrors, NameTheLoopAndItsClosure) {
    Random random(27);
    SimulatedGraph simulated(random, 5, {{0, 1}, {1, 2}, {3, 2}, {3, 4}, {4, 1}}, kUtm);
    PoseGraph& graph = simulated.graph;
    for (PoseEdge& edge : graph.edges)
        edge.toFromFrom = simulated.truth[edge.to].inverse() * simulated.truth[edge.from];
    AdjustedGraph adjusted = adjustGraph(graph);
    ASSERT_EQ(adjusted.loops.size(), 1u);
    EXPECT_LT(adjusted.loops[0].translation_m, 1e-8);
    EXPECT_NEAR(adjusted.loops[0].probability, 1, 1e-6);

    graph.edges[2].toFromFrom = shift(0.03, 0, 0.04) * graph.edges[2].toFromFrom;
    adjusted = adjustGraph(graph);
    ASSERT_EQ(adjusted.loops.size(), 1u);
    const LoopError& loop = adjusted.loops[0];
    EXPECT_NEAR(loop.translation_m, 0.05, 1e-6) << "a shift of one edge is the shift of the loop";
    EXPECT_LT(loop.rotation_rad, 1e-7);
    EXPECT_EQ(loop.nodes.size(), 4u);
    EXPECT_EQ(loop.edges.size(), 4u);
    EXPECT_THAT(loop.nodes, testing::Not(testing::Contains(0u))) << "the way to the target is no part of it";
    // One loop: the adjustment's sum of squares is the closure's.
    EXPECT_NEAR(loop.chiSquare, adjusted.fit.chiSquare, 1e-2 * loop.chiSquare);
}

TEST(LoopErrors, OfRightEdgesFollowChiSquare) {
    Random random(28);
    SimulatedGraph simulated(random, 5, kRound, kUtm);
    double mean = 0;
    constexpr int kTrials = 300;
    for (int trial = 0; trial < kTrials; ++trial) {
        simulated.measure(random);
        const AdjustedGraph adjusted = adjustGraph(simulated.graph);
        ASSERT_EQ(adjusted.loops.size(), 3u);
        for (const LoopError& loop : adjusted.loops) mean += loop.chiSquare / (3 * kTrials);
    }
    EXPECT_NEAR(mean, 6, 0.5);
}

}  // namespace
}  // namespace vestige
