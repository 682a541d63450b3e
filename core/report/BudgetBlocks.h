#pragma once

#include "core/report/Section.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {

/// The budget of the main figure of every object and method, a table each; those of the other figures are in
/// uncertainty.csv.
void addBudgets(Section& section, const MeasuredScene& measured);

/// "1.2 mm" for small lengths, else four significant digits with the unit.
std::string inputText(double value, const std::string& unit);

}  // namespace vestige
