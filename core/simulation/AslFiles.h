#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/base/Result.h"
#include "core/simulation/TiltingScanner.h"

namespace vestige {

/// The layout of the ETH ASL data sets (Pomerleau et al. 2012): Hokuyo_N.csv in the scanner's frame or
/// PointCloudN.csv in the world's, header Time_in_sec,x,y,z,Intensities,2DscanId,PointId, metres.
enum class AslFrame { scanner, world };

/// "Hokuyo_7.csv", "PointCloud7.csv".
std::string aslCloudName(AslFrame frame, std::size_t number);

/// Coordinates with four decimals. Time is `start_s` and the point's own. ErrorCode::output.
Status writeAslCloud(const std::filesystem::path& file, std::span<const TiltedPoint> points, double start_s,
                     const Pose& frameFromScanner);

/// pose_scanner_leica.csv: poseId,timestamp,T00,...,T33 with worldFromScanner of every scan.
struct StampedPose {
    double time_s = 0;
    Pose worldFromScanner = Pose::Identity();
};
Status writeAslPoses(const std::filesystem::path& file, std::span<const StampedPose> poses);

}  // namespace vestige
