#include "core/evaluation/RelativePoseError.h"

#include <cmath>
#include <string>

namespace vestige {

Result<RelativePoseError> relativePoseError(std::span<const Pose> estimates, std::span<const Pose> truth,
                                            std::size_t distance) {
    if (estimates.size() != truth.size())
        return fail(ErrorCode::input, "there are " + std::to_string(estimates.size()) + " estimates and " +
                                          std::to_string(truth.size()) + " known poses");
    if (distance == 0 || estimates.size() <= distance)
        return fail(ErrorCode::input, "no two poses are " + std::to_string(distance) + " apart");
    RelativePoseError error;
    error.pairs = estimates.size() - distance;
    for (std::size_t i = 0; i < error.pairs; ++i) {
        const Pose moved = truth[i].inverse() * truth[i + distance];
        const Pose e = moved.inverse() * (estimates[i].inverse() * estimates[i + distance]);
        const double angle = rotationAngle(e.linear());
        error.translation_m += e.translation().squaredNorm();
        error.rotation_rad += angle * angle;
    }
    error.translation_m = std::sqrt(error.translation_m / static_cast<double>(error.pairs));
    error.rotation_rad = std::sqrt(error.rotation_rad / static_cast<double>(error.pairs));
    return error;
}

}  // namespace vestige
