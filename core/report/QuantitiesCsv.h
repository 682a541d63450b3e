#pragma once

#include <string>

#include "core/scene/MeasuredScene.h"

namespace vestige {

/// quantities.csv: a row per figure of every object and method, numbers exact, empty where there is none.
std::string quantitiesCsv(const MeasuredScene& measured);

/// uncertainty.csv: a row per line of every budget, in the order of the
/// budget.
std::string uncertaintyCsv(const MeasuredScene& measured);

}  // namespace vestige
