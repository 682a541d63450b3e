#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/registration/adjustment/PoseGraph.h"

namespace vestige {

/// Least squares over all poses: minimises the sum of r' C^-1 r over the edges used, r of edgeResidual() and
/// C its covariance, by Levenberg's method from the poses along the surest tree.
struct FittedPoses {
    std::vector<std::optional<Pose>> poses;                   ///< nothing for nodes out of reach
    std::vector<std::optional<PoseUncertainty>> uncertainty;  ///< a posteriori, about the nodes' centres
    double chiSquare = 0;                                     ///< the sum at the minimum
    int degrees = 0;  ///< of freedom: 6 (edges between nodes in reach - free nodes in reach)
    int iterations = 0;
    bool converged = false;
};

/// `used` marks the edges that take part. An edge whose covariance is not positive definite must not be used.
FittedPoses fitPoses(const PoseGraph& graph, const std::vector<bool>& used);

/// Finite and positive definite.
bool isUsable(const PoseUncertainty& uncertainty);

}  // namespace vestige
