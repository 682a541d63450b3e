#include "core/evaluation/SequenceCsv.h"

#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/base/Units.h"

namespace vestige {
namespace {

std::string voxelText(const SequenceScore& score) {
    return score.voxel_m ? exactText(*score.voxel_m) : std::string();
}

}  // namespace

std::string sequenceCsv(const std::vector<SequenceScore>& scores) {
    std::string text = csvLine({"method", "voxel_m", "filter", "pairs", "failed", "rpe_m", "rpe_deg",
                                "seconds", "preprocess_seconds", "delta", "rpe_median_m", "rpe_max_m",
                                "rpe_median_deg", "rpe_max_deg"});
    for (const SequenceScore& score : scores) {
        const RelativePoseError& error = score.error;
        text += csvLine({score.method, voxelText(score), score.filter, std::to_string(error.pairs),
                         std::to_string(score.failed), exactText(error.translation_m),
                         exactText(degrees(error.rotation_rad)), exactText(score.seconds),
                         exactText(score.preprocessSeconds), std::to_string(score.distance),
                         exactText(error.median.translation_m), exactText(error.largest.translation_m),
                         exactText(degrees(error.median.rotation_rad)),
                         exactText(degrees(error.largest.rotation_rad))});
    }
    return text;
}

std::string pairsCsv(const std::vector<SequenceScore>& scores) {
    std::string text = csvLine({"method", "voxel_m", "filter", "target", "source", "moved_m", "moved_deg",
                                "error_m", "error_deg", "verdict", "overlap", "seconds"});
    for (const SequenceScore& score : scores)
        for (const PairScore& pair : score.pairs)
            text += csvLine({score.method, voxelText(score), score.filter, std::to_string(pair.from),
                             std::to_string(pair.from + 1), exactText(pair.moved.translation_m),
                             exactText(degrees(pair.moved.rotation_rad)), exactText(pair.error.translation_m),
                             exactText(degrees(pair.error.rotation_rad)), std::string(describe(pair.verdict)),
                             exactText(pair.overlap), exactText(pair.seconds)});
    return text;
}

}  // namespace vestige
