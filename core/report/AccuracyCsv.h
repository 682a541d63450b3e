#pragma once

#include <span>
#include <string>

#include "core/measurement/Accuracy.h"

namespace vestige {

/// accuracy.csv: `method,n,sd,rmse,rmse_all,rmse_abs_m,excluded`, fractions (0.0427 is 4.27 %), numbers
/// exact, the names of excluded objects joined by ';'.
std::string accuracyCsv(std::span<const MethodAccuracy> methods);

}  // namespace vestige
