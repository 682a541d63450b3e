#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scene/JointAdjustment.h"

namespace vestige {

/// The object that adjustment.json holds (docs/formats.md): the pairs, the loops, the layers; metres, radians
/// as degrees. The same text for the same adjustment.
nlohmann::json adjustmentJson(const JointAdjustment& adjustment);

}  // namespace vestige
