#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/Error.h"
#include "core/registration/RegistrationResult.h"

namespace vestige {

/// The evidence for a verdict, the same in `register --json` and in a case file; its covariance is about its
/// `pivot_m`, of (t in metres, w in radians), row by row.
nlohmann::ordered_json qualityJson(const RegistrationQuality& quality);

/// The object that `register --json` prints and registration.json lists (docs/formats.md): pose as 16 numbers
/// row by row, metres; the covariance of the pose about its own translation, 36 numbers; verdict, reasons and
/// the evidence for them. `seconds` is left out where the text must not differ from run to run.
nlohmann::json registrationJson(const RegistrationResult& result, bool withSeconds);

/// The same object where the error came before there was a result: verdict failed, the error's sentence as
/// its reason, pose and figures null; `candidates` are those of a search that had found some.
nlohmann::json failedRegistrationJson(const std::string& method, const Error& error,
                                      const std::vector<PoseCandidate>& candidates);

}  // namespace vestige
