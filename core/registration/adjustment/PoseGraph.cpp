#include "core/registration/adjustment/PoseGraph.h"

#include <limits>

#include "core/registration/adjustment/RotationVector.h"

namespace vestige {

EdgeResidual edgeResidual(const PoseEdge& edge, const Pose& to, const Pose& from, const Eigen::Vector3d& pTo,
                          const Eigen::Vector3d& pFrom) {
    const Eigen::Vector3d& pivot = edge.uncertainty.pivot_m;
    const Eigen::Matrix3d toScene = to.linear().transpose();
    // The point of `from` that M puts on the pivot, where `from` has it in the scene.
    const Eigen::Vector3d y =
        from * (edge.toFromFrom.linear().transpose() * (pivot - edge.toFromFrom.translation()));
    EdgeResidual residual;
    residual.value.head<3>() = toScene * (y - to.translation()) - pivot;
    const Eigen::Vector3d w = rotationLog(toScene * from.linear() * edge.toFromFrom.linear().transpose());
    residual.value.tail<3>() = w;

    const Eigen::Matrix3d turn = inverseLeftJacobian(w) * toScene;
    residual.byFrom.setZero();
    residual.byFrom.topLeftCorner<3, 3>() = toScene;
    residual.byFrom.topRightCorner<3, 3>() = -toScene * crossMatrix(y - pFrom);
    residual.byFrom.bottomRightCorner<3, 3>() = turn;
    residual.byTo.setZero();
    residual.byTo.topLeftCorner<3, 3>() = -toScene;
    residual.byTo.topRightCorner<3, 3>() = toScene * crossMatrix(y - pTo);
    residual.byTo.bottomRightCorner<3, 3>() = -turn;
    return residual;
}

Pose moved(const Pose& pose, const Vector6d& motion, const Eigen::Vector3d& p) {
    const Eigen::Matrix3d turn = rotationExp(motion.tail<3>());
    Pose result = Pose::Identity();
    result.linear() = turn * pose.linear();
    result.translation() = turn * (pose.translation() - p) + p + motion.head<3>();
    return result;
}

PoseUncertainty inScene(const PoseUncertainty& ofEdge, const Pose& sceneFromTo) {
    Matrix6d turn = Matrix6d::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = sceneFromTo.linear();
    return {turn * ofEdge.covariance * turn.transpose(), sceneFromTo * ofEdge.pivot_m};
}

std::vector<TreeStep> surestTree(const PoseGraph& graph, const std::vector<bool>& used) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::vector<double> cost(graph.nodes.size(), kFar);
    std::vector<bool> done(graph.nodes.size(), false);
    std::vector<TreeStep> via(graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        if (graph.nodes[i].fixed) cost[i] = 0;
    std::vector<TreeStep> tree;
    for (;;) {
        std::size_t node = graph.nodes.size();
        for (std::size_t i = 0; i < graph.nodes.size(); ++i)
            if (!done[i] && cost[i] < kFar && (node == graph.nodes.size() || cost[i] < cost[node])) node = i;
        if (node == graph.nodes.size()) return tree;
        done[node] = true;
        if (!graph.nodes[node].fixed) tree.push_back(via[node]);
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const PoseEdge& edge = graph.edges[e];
            if (!used[e] || (edge.to != node && edge.from != node)) continue;
            const std::size_t other = edge.to == node ? edge.from : edge.to;
            const double reached = cost[node] + edge.uncertainty.covariance.trace();
            if (done[other] || !(reached < cost[other])) continue;
            cost[other] = reached;
            via[other] = {other, node, e};
        }
    }
}

std::vector<std::optional<ChainedPose>> posesAlong(const PoseGraph& graph,
                                                   const std::vector<TreeStep>& tree) {
    std::vector<std::optional<ChainedPose>> poses(graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const PoseNode& node = graph.nodes[i];
        if (node.fixed) poses[i] = ChainedPose{node.pose, {Matrix6d::Zero(), node.pose * node.centre_m}};
    }
    for (const TreeStep& step : tree) {
        const PoseEdge& edge = graph.edges[step.edge];
        const ChainedPose& before = *poses[step.before];
        ChainedPose reached;
        reached.pose = before.pose * (edge.to == step.before ? edge.toFromFrom : edge.toFromFrom.inverse());
        const Eigen::Vector3d centre = reached.pose * graph.nodes[step.node].centre_m;
        const Pose& to = edge.to == step.before ? before.pose : reached.pose;
        reached.uncertainty = before.uncertainty.about(centre);
        reached.uncertainty.covariance += inScene(edge.uncertainty, to).about(centre).covariance;
        poses[step.node] = reached;
    }
    return poses;
}

}  // namespace vestige
