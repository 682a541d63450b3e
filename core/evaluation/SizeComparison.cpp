#include "core/evaluation/SizeComparison.h"

#include <cmath>

namespace vestige {

const SequenceScore* scoreOf(std::span<const SequenceScore> scores, std::string_view method,
                             std::string_view filter, double voxel_m) {
    for (const SequenceScore& score : scores)
        if (score.method == method && score.filter == filter && score.voxel_m &&
            std::abs(*score.voxel_m - voxel_m) < 1e-9)
            return &score;
    return nullptr;
}

std::optional<SizeComparison> compareBySize(std::span<const SequenceScore> scores, std::string_view method,
                                            std::string_view other) {
    SizeComparison comparison;
    for (const SequenceScore& score : scores) {
        if (score.method != method || score.filter != "none" || !score.voxel_m) continue;
        const SequenceScore* beside = scoreOf(scores, other, "none", *score.voxel_m);
        if (!beside || !(beside->error.translation_m > 0)) continue;
        const double ratio = score.error.translation_m / beside->error.translation_m;
        ++comparison.sizes;
        if (ratio < 1) ++comparison.lower;
        if (ratio > comparison.worstRatio) {
            comparison.worstRatio = ratio;
            comparison.worstVoxel_m = *score.voxel_m;
        }
        comparison.mean_m += score.error.translation_m;
        comparison.otherMean_m += beside->error.translation_m;
    }
    if (comparison.sizes == 0) return std::nullopt;
    comparison.mean_m /= static_cast<double>(comparison.sizes);
    comparison.otherMean_m /= static_cast<double>(comparison.sizes);
    return comparison;
}

}  // namespace vestige
