#pragma once

#include <vector>

#include "core/report/Section.h"
#include "core/scene/Layer.h"

namespace vestige {

/// What a registration says of itself, for people: verdict and reasons, uncertainty at 95 %, what the data
/// hold and what not, restarts, residuals. The verdict alone for a result without quality (of an older case
/// file).
std::vector<Block> qualityBlocks(const RegistrationResult& result);

}  // namespace vestige
