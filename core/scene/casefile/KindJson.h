#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scene/Measurement.h"
#include "core/scene/casefile/JsonCursor.h"

namespace vestige {

/// Kind, settings, check and paths of a measurement, into its object; nothing of what is as by default.
void addKindJson(nlohmann::ordered_json& json, const Measurement& measurement);
/// The same back. Settings that the kind does not have are warned of and left out; values out of range are
/// rejected.
void readKind(const JsonCursor& cursor, Measurement& measurement);

/// A point as the end of a pair has it: [layer, [x,y,z], {...}].
nlohmann::ordered_json pickedPointJson(const PickedPoint& point);
PickedPoint readPickedPoint(const JsonCursor& cursor);

}  // namespace vestige
