#include "core/registration/adjustment/AdjustPoses.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace vestige {
namespace {

constexpr int kMostIterations = 100;
/// A step that moves no point near a scan by more than this (metres, radians) ends the fit.
/// Coordinates of millions of metres are good to a nanometre.
constexpr double kNegligible = 1e-8;

/// The free nodes in reach, numbered, and the edges between nodes in reach.
struct Problem {
    const PoseGraph& graph;
    std::vector<std::size_t> free;
    std::vector<int> slot;  // of a node among `free`; -1 for the others
    std::vector<std::size_t> edges;
    std::vector<Matrix6d> information;  // one per entry of `edges`
};

struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd slope;
    double chiSquare = 0;
};

double chiSquareOf(const Problem& problem, const std::vector<Pose>& poses) {
    double sum = 0;
    for (std::size_t i = 0; i < problem.edges.size(); ++i) {
        const PoseEdge& edge = problem.graph.edges[problem.edges[i]];
        const Vector6d r = edgeResidual(edge, poses[edge.to], poses[edge.from], Eigen::Vector3d::Zero(),
                                        Eigen::Vector3d::Zero())
                               .value;
        sum += r.dot(problem.information[i] * r);
    }
    return sum;
}

NormalEquations normalEquations(const Problem& problem, const std::vector<Pose>& poses) {
    const auto size = static_cast<Eigen::Index>(6 * problem.free.size());
    NormalEquations normal{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size), 0};
    const auto centre = [&](std::size_t node) -> Eigen::Vector3d {
        return poses[node] * problem.graph.nodes[node].centre_m;
    };
    for (std::size_t i = 0; i < problem.edges.size(); ++i) {
        const PoseEdge& edge = problem.graph.edges[problem.edges[i]];
        const EdgeResidual residual =
            edgeResidual(edge, poses[edge.to], poses[edge.from], centre(edge.to), centre(edge.from));
        const Matrix6d& weight = problem.information[i];
        normal.chiSquare += residual.value.dot(weight * residual.value);
        const std::pair<int, const Matrix6d*> sides[] = {{problem.slot[edge.to], &residual.byTo},
                                                         {problem.slot[edge.from], &residual.byFrom}};
        for (const auto& [row, byRow] : sides) {
            if (row < 0) continue;
            normal.slope.segment<6>(6 * row) += byRow->transpose() * weight * residual.value;
            for (const auto& [column, byColumn] : sides)
                if (column >= 0)
                    normal.matrix.block<6, 6>(6 * row, 6 * column) += byRow->transpose() * weight * *byColumn;
        }
    }
    return normal;
}

std::vector<Pose> steppedBy(const Problem& problem, std::vector<Pose> poses, const Eigen::VectorXd& step) {
    for (std::size_t i = 0; i < problem.free.size(); ++i) {
        Pose& pose = poses[problem.free[i]];
        pose = moved(pose, step.segment<6>(static_cast<Eigen::Index>(6 * i)),
                     pose * problem.graph.nodes[problem.free[i]].centre_m);
    }
    return poses;
}

Problem problemOf(const PoseGraph& graph, const std::vector<bool>& used,
                  const std::vector<std::optional<ChainedPose>>& start) {
    Problem problem{graph, {}, std::vector<int>(graph.nodes.size(), -1), {}, {}};
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        if (!start[i] || graph.nodes[i].fixed) continue;
        problem.slot[i] = static_cast<int>(problem.free.size());
        problem.free.push_back(i);
    }
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const PoseEdge& edge = graph.edges[e];
        const bool betweenFixed = graph.nodes[edge.to].fixed && graph.nodes[edge.from].fixed;
        if (!used[e] || !start[edge.to] || !start[edge.from] || betweenFixed) continue;
        problem.edges.push_back(e);
        problem.information.push_back(edge.uncertainty.covariance.ldlt().solve(Matrix6d::Identity()));
    }
    return problem;
}

/// Levenberg's method with the diagonal of the normal matrix as its scale (Marquardt 1963).
void descend(const Problem& problem, std::vector<Pose>& poses, FittedPoses& fit) {
    double damping = 1e-6;
    NormalEquations normal = normalEquations(problem, poses);
    while (!fit.converged && fit.iterations < kMostIterations && damping < 1e12) {
        ++fit.iterations;
        Eigen::MatrixXd damped = normal.matrix;
        damped.diagonal() += damping * normal.matrix.diagonal();
        const Eigen::VectorXd step = -damped.ldlt().solve(normal.slope);
        if (!step.allFinite()) return;
        std::vector<Pose> tried = steppedBy(problem, poses, step);
        if (chiSquareOf(problem, tried) <= normal.chiSquare) {
            poses = std::move(tried);
            normal = normalEquations(problem, poses);
            damping *= 0.1;
        } else {
            damping *= 10;
        }
        fit.converged = step.cwiseAbs().maxCoeff() < kNegligible;
    }
}

}  // namespace

FittedPoses fitPoses(const PoseGraph& graph, const std::vector<bool>& used) {
    const auto start = posesAlong(graph, surestTree(graph, used));
    const Problem problem = problemOf(graph, used, start);
    std::vector<Pose> poses(graph.nodes.size(), Pose::Identity());
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (start[i]) poses[i] = start[i]->pose;

    FittedPoses fit;
    fit.poses.resize(poses.size());
    fit.uncertainty.resize(poses.size());
    fit.degrees = 6 * (static_cast<int>(problem.edges.size()) - static_cast<int>(problem.free.size()));
    if (fit.degrees > 0)
        descend(problem, poses, fit);
    else
        fit.converged = true;  // every edge holds exactly
    const NormalEquations normal = normalEquations(problem, poses);
    fit.chiSquare = normal.chiSquare;
    const Eigen::MatrixXd inverse =
        normal.matrix.ldlt().solve(Eigen::MatrixXd::Identity(normal.matrix.rows(), normal.matrix.cols()));
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (!start[i]) continue;
        fit.poses[i] = poses[i];
        PoseUncertainty uncertainty{Matrix6d::Zero(), poses[i] * graph.nodes[i].centre_m};
        if (const int slot = problem.slot[i]; slot >= 0) {
            const Matrix6d block = inverse.block<6, 6>(6 * slot, 6 * slot);
            uncertainty.covariance = 0.5 * (block + block.transpose());
        }
        fit.uncertainty[i] = uncertainty;
    }
    return fit;
}

bool isUsable(const PoseUncertainty& uncertainty) {
    if (!uncertainty.covariance.allFinite() || !uncertainty.pivot_m.allFinite()) return false;
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(uncertainty.covariance, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0] > 0;
}

}  // namespace vestige
