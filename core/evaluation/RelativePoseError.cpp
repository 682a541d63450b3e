#include "core/evaluation/RelativePoseError.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vestige {
namespace {

double middle(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

Result<RelativePoseError> relativePoseError(std::span<const Pose> estimates, std::span<const Pose> truth,
                                            std::size_t distance) {
    if (estimates.size() != truth.size())
        return fail(ErrorCode::input, "there are " + std::to_string(estimates.size()) + " estimates and " +
                                          std::to_string(truth.size()) + " known poses");
    if (distance == 0 || estimates.size() <= distance)
        return fail(ErrorCode::input, "no two poses are " + std::to_string(distance) + " apart", {},
                    "expected a distance from 1 to " +
                        std::to_string(std::max<std::size_t>(estimates.size(), 2) - 1));
    RelativePoseError error;
    error.pairs = estimates.size() - distance;
    std::vector<double> shifts, turns;
    for (std::size_t i = 0; i < error.pairs; ++i) {
        const Pose moved = truth[i].inverse() * truth[i + distance];
        const Pose e = moved.inverse() * (estimates[i].inverse() * estimates[i + distance]);
        const PoseDifference one{e.translation().norm(), rotationAngle(e.linear())};
        error.translation_m += one.translation_m * one.translation_m;
        error.rotation_rad += one.rotation_rad * one.rotation_rad;
        error.largest.translation_m = std::max(error.largest.translation_m, one.translation_m);
        error.largest.rotation_rad = std::max(error.largest.rotation_rad, one.rotation_rad);
        shifts.push_back(one.translation_m);
        turns.push_back(one.rotation_rad);
        error.each.push_back(one);
    }
    error.translation_m = std::sqrt(error.translation_m / static_cast<double>(error.pairs));
    error.rotation_rad = std::sqrt(error.rotation_rad / static_cast<double>(error.pairs));
    error.median = {middle(std::move(shifts)), middle(std::move(turns))};
    return error;
}

}  // namespace vestige
