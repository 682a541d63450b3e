#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/evaluation/SequenceEvaluation.h"

namespace vestige {

/// The score of this method, filter and voxel; nothing where it was not run.
const SequenceScore* scoreOf(std::span<const SequenceScore> scores, std::string_view method,
                             std::string_view filter, double voxel_m);

/// How one method stands against another over the voxel sizes at which both were run on unfiltered clouds.
struct SizeComparison {
    std::size_t sizes = 0;
    std::size_t lower = 0;    ///< sizes at which the relative pose error is lower
    double mean_m = 0;        ///< mean RPE over the sizes
    double otherMean_m = 0;   ///< of the method that it is compared with
    double worstRatio = 0;    ///< largest RPE / other RPE
    double worstVoxel_m = 0;  ///< where that is
};
std::optional<SizeComparison> compareBySize(std::span<const SequenceScore> scores, std::string_view method,
                                            std::string_view other);

}  // namespace vestige
