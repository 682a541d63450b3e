#pragma once

#include <string>
#include <vector>

#include "core/scene/MeasuredScene.h"

namespace vestige {

/// What may be said of the survey as a whole, in a sentence: "verified" only where a known distance agreed.
std::string verificationSentence(const MeasuredScene& measured);

/// A sentence for each known distance that failed, for the log and the notes of a run.
std::vector<std::string> failedChecks(const MeasuredScene& measured);

}  // namespace vestige
