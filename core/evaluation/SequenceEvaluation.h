#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/evaluation/RelativePoseError.h"
#include "core/evaluation/Sequence.h"
#include "core/registration/RegistrationQuality.h"

namespace vestige {

/// One cloud registered to the one before.
struct PairScore {
    std::size_t from = 0;  ///< index of the target; the source is the next
    PoseDifference moved;  ///< true motion between the two
    PoseDifference error;
    Verdict verdict = Verdict::failed;
    double overlap = 0;
    double seconds = 0;  ///< until the pose is found, its verdict not included
};

/// One row of the comparison.
struct SequenceScore {
    std::string method;
    std::optional<double> voxel_m;  ///< nothing: chosen by the registration
    std::string filter;
    std::size_t distance = 1;  ///< between the poses that are compared
    RelativePoseError error;
    std::size_t failed = 0;        ///< registrations with the verdict failed or ambiguous
    double seconds = 0;            ///< registration, all pairs
    double preprocessSeconds = 0;  ///< all clouds
    std::vector<PairScore> pairs;  ///< neighbours, whatever `distance`
};

/// Registers each cloud to the one before, from identity, and compares the chain of poses with the truth.
/// The pose that a method ends at counts, whatever its verdict; where it has none, the scanner counts as not
/// moved. ErrorCode::input when no poses are `distance` apart.
Result<SequenceScore> evaluateSequence(const Sequence& sequence, const ParameterSet& preprocessing,
                                       const ParameterSet& registration, std::size_t distance = 1,
                                       const JobControl& control = {});

}  // namespace vestige
