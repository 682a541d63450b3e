#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/simulation/AslFiles.h"

namespace vestige {

struct SequenceOptions {
    std::uint64_t seed = 1;
    std::size_t scans = 32;
    std::size_t beams = 65000;  ///< of one scan; some two thirds answer
    AslFrame frame = AslFrame::scanner;
};

struct SimulatedSequence {
    std::vector<std::string> files;  ///< relative to the folder
    std::vector<std::size_t> points;
};

/// The pavilion (PavilionScene.h) scanned by a tilting Hokuyo at every stop of the walk, in the ASL layout:
/// a cloud per scan and pose_scanner_leica.csv with the true poses. The same seed gives the same files,
/// whatever the number of threads. Errors: cancelled; ErrorCode::output, what was written before stays whole.
Result<SimulatedSequence> simulatePavilion(const SequenceOptions& options,
                                           const std::filesystem::path& folder, const JobControl& control);

}  // namespace vestige
