#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/scene/Measurement.h"

namespace vestige {

/// Actions that pick a kind of measurement with the path tool, and the kind of each, in the order of the
/// menu.
const std::vector<std::pair<const char*, MeasurementKind>>& kindTools();
/// The name of a kind's icon.
std::string kindIcon(MeasurementKind kind);

}  // namespace vestige
