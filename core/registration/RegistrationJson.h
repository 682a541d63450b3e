#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/registration/RegistrationResult.h"

namespace vestige {

/// The object that `register --json` prints and registration.json lists: pose as 16 numbers row by row,
/// metres. `seconds` is left out where the text must not differ from run to run. A result that cannot be
/// relied on has "verdict": "failed" and its reasons.
nlohmann::json registrationJson(const RegistrationResult& result, bool withSeconds);

}  // namespace vestige
