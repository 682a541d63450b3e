#include "core/pipeline/joint/PairUncertainty.h"

#include <algorithm>
#include <cmath>

namespace vestige {

PoseUncertainty pairUncertainty(const RegistrationResult& result, const Layer& source) {
    if (result.quality) return result.quality->uncertainty;
    constexpr double kLeast_m = 1e-4;
    const BoundingBox& bounds = source.data->points->bounds();
    const double sigma_m = std::max(kLeast_m, result.rmse_m) / std::sqrt(std::max(result.overlap, 0.01));
    const double arm_m = result.targetFromSource.scale * bounds.diagonal() / 2;
    PoseUncertainty uncertainty{Matrix6d::Zero(), result.targetFromSource * bounds.centre()};
    uncertainty.covariance.diagonal().head<3>().setConstant(sigma_m * sigma_m);
    uncertainty.covariance.diagonal().tail<3>().setConstant(std::pow(sigma_m / arm_m, 2));
    return uncertainty;
}

}  // namespace vestige
