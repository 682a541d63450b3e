#pragma once

#include <string>
#include <vector>

#include "core/base/ParameterSet.h"
#include "core/base/Result.h"

namespace vestige {

/// One run of a comparison: preprocessParameters() and registrationParameters() with values.
struct EvaluationRun {
    ParameterSet preprocessing;
    ParameterSet registration;
};

/// registrationParameters() as a comparison uses them: without restarts, whose time says nothing of a method.
ParameterSet comparedRegistration();

/// What to compare: every combination of these. Voxels are lengths in metres, or "auto".
struct EvaluationChoice {
    std::vector<std::string> methods;
    std::vector<std::string> voxels;
    std::vector<std::string> filters;
};

/// What the publication compares. Table 2: classic and improved NDT at six voxel sizes, unfiltered. Table 3:
/// improved NDT behind three filters at three sizes. Any other number: nothing.
EvaluationChoice publishedChoice(int table);

/// Every combination of every choice, each once, in order. All else is as in `preprocessing` and
/// `registration`. ErrorCode::usage names a value that does not exist.
Result<std::vector<EvaluationRun>> evaluationRuns(const std::vector<EvaluationChoice>& choices,
                                                  const ParameterSet& preprocessing,
                                                  const ParameterSet& registration);

}  // namespace vestige
