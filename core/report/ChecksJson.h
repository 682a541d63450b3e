#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scene/MeasuredScene.h"

namespace vestige {

/// The list `quantities` of `reconstruct`: every figure with its budget. A value that does not exist, or is
/// infinite, is null.
nlohmann::json quantitiesJson(const MeasuredScene& measured);

/// `checks` of `reconstruct`: {"verification": "verified" | "not verified" | "failed", "known_distances":
/// [...]}.
nlohmann::json checksJson(const MeasuredScene& measured);

}  // namespace vestige
