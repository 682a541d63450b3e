#pragma once

#include <filesystem>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// Clouds in their scanner's frames, metres, and the known poses worldFromScanner.
struct Sequence {
    std::vector<PointCloud> clouds;
    std::vector<Pose> truth;
};

/// Whether the clouds of a folder stand in their scanner's frame or all in the frame of the known poses;
/// `byName`: ASL's PointCloudN.csv in the latter, all others in the former.
enum class SequenceFrame { byName, scanner, world };

/// Reads what sequenceFiles and readTrajectory find. A cloud with a number belongs to the pose with that
/// poseId; where the numbers of clouds and poses differ by a constant, or there are none, the order counts.
/// ErrorCode::input when clouds and poses cannot be paired.
Result<Sequence> readSequence(const std::filesystem::path& folder, const std::filesystem::path& truth,
                              SequenceFrame frame = SequenceFrame::byName, const JobControl& control = {});

/// What a report says of a sequence.
struct SequenceExtent {
    std::size_t clouds = 0;
    std::size_t points = 0;
    double path_m = 0;           ///< along the known poses
    double longestStep_m = 0;    ///< between neighbours
    double largestTurn_rad = 0;  ///< between neighbours
};
SequenceExtent extentOf(const Sequence& sequence);

}  // namespace vestige
