#include "core/registration/adjustment/LoopErrors.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/registration/adjustment/SignificanceTests.h"

namespace vestige {
namespace {

/// The steps from a fixed node to `node`, the last one first.
std::vector<TreeStep> wayBack(const std::vector<TreeStep>& tree, std::size_t node) {
    std::vector<TreeStep> way;
    for (auto step = tree.rbegin(); step != tree.rend(); ++step) {
        if (step->node != node) continue;
        way.push_back(*step);
        node = step->before;
    }
    return way;
}

}  // namespace

std::vector<LoopError> loopErrors(const PoseGraph& graph, const std::vector<TreeStep>& tree,
                                  const std::vector<bool>& measured) {
    const auto poses = posesAlong(graph, tree);
    std::vector<bool> inTree(graph.edges.size(), false);
    for (const TreeStep& step : tree) inTree[step.edge] = true;
    std::vector<LoopError> loops;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const PoseEdge& edge = graph.edges[e];
        if (!measured[e] || inTree[e] || !poses[edge.to] || !poses[edge.from]) continue;
        std::vector<TreeStep> back = wayBack(tree, edge.to);
        std::vector<TreeStep> forth = wayBack(tree, edge.from);
        // What both ways share is walked to and fro and cancels.
        while (!back.empty() && !forth.empty() && back.back().edge == forth.back().edge) {
            back.pop_back();
            forth.pop_back();
        }
        LoopError loop;
        loop.closing = e;
        const Pose& to = poses[edge.to]->pose;
        const Eigen::Vector3d pivot = to * edge.uncertainty.pivot_m;
        Matrix6d covariance = inScene(edge.uncertainty, to).covariance;
        const auto walk = [&](const TreeStep& step) {
            const PoseEdge& walked = graph.edges[step.edge];
            loop.edges.push_back(step.edge);
            covariance += inScene(walked.uncertainty, poses[walked.to]->pose).about(pivot).covariance;
        };
        for (const TreeStep& step : back) {
            loop.nodes.push_back(step.node);
            walk(step);
        }
        loop.nodes.push_back(back.empty() ? edge.to : back.back().before);
        if (!forth.empty() && forth.back().before != loop.nodes.back())
            loop.nodes.push_back(forth.back().before);  // between two fixed nodes
        for (auto step = forth.rbegin(); step != forth.rend(); ++step) {
            walk(*step);
            loop.nodes.push_back(step->node);
        }
        if (loop.nodes.back() != edge.from) loop.nodes.push_back(edge.from);
        loop.edges.push_back(e);
        loop.closure =
            edgeResidual(edge, to, poses[edge.from]->pose, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero())
                .value;
        loop.translation_m = loop.closure.head<3>().norm();
        loop.rotation_rad = loop.closure.tail<3>().norm();
        Vector6d closure;
        closure << to.linear() * loop.closure.head<3>(), to.linear() * loop.closure.tail<3>();
        loop.chiSquare = closure.dot(covariance.ldlt().solve(closure));
        loop.probability = chiSquareTail(loop.chiSquare, 6);
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace vestige
