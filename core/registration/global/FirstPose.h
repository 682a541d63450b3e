#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"
#include "core/registration/RegistrationResult.h"

namespace vestige {

/// Where a source lies on a target, found from nothing but the two.
struct FirstPose {
    Similarity targetFromSource;
    std::optional<double> error_m;  ///< how far off it may be, where the source is a small part of the target
    std::vector<PoseCandidate> candidates;  ///< distinct poses, the best first; at most eight
    bool ambiguous = false;                 ///< the data cannot tell the first candidates apart
    std::vector<std::string> notes;         ///< unit, candidates and their scores
};

/// Searches all places and rotations (docs/decisions/0008). `metresPerUnit` of the source; where it is not
/// given and the sizes do not settle it, metres and millimetres are both tried. The target is in metres.
/// `parameters` are those of registrationParameters(). Bit-identical for any thread count.
/// ErrorCode::untrustworthy when nothing in the target looks like the source.
Result<FirstPose> findFirstPose(const TriangleMesh& target, const TriangleMesh& source,
                                std::optional<double> metresPerUnit, const ParameterSet& parameters,
                                const JobControl& control = {});

/// Says in the result of a registration that started there what the search found: its notes and candidates,
/// and the verdict ambiguous (a failed registration stays failed).
void addFirstPose(RegistrationResult& result, const FirstPose& first);

}  // namespace vestige
