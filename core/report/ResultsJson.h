#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>
#include "core/measurement/Accuracy.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {

/// The list `methods` of the `accuracy` command and `accuracy` of `reconstruct`: re, sd, rmse are fractions,
/// a value that does not exist is null.
nlohmann::json accuracyJson(std::span<const MethodAccuracy> methods);

/// The list `measurements` of `reconstruct`, an object per row of measurements.csv.
nlohmann::json measurementsJson(const MeasuredScene& measured);

}  // namespace vestige
