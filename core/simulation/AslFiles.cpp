#include "core/simulation/AslFiles.h"

#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"

namespace vestige {

std::string aslCloudName(AslFrame frame, std::size_t number) {
    return (frame == AslFrame::world ? "PointCloud" : "Hokuyo_") + std::to_string(number) + ".csv";
}

Status writeAslCloud(const std::filesystem::path& file, std::span<const TiltedPoint> points, double start_s,
                     const Pose& frameFromScanner) {
    std::string text = "Time_in_sec,x,y,z,Intensities,2DscanId,PointId\n";
    for (const TiltedPoint& point : points) {
        const Eigen::Vector3d at = frameFromScanner * point.position;
        text += fixedText(start_s + point.time_s, 4) + ',' + fixedText(at.x(), 4) + ',' +
                fixedText(at.y(), 4) + ',' + fixedText(at.z(), 4) + ',' +
                fixedText(static_cast<double>(point.intensity), 0) + ',' + std::to_string(point.line) + ',' +
                std::to_string(point.beam) + '\n';
    }
    return writeTextFile(file, text);
}

Status writeAslPoses(const std::filesystem::path& file, std::span<const StampedPose> poses) {
    std::string text = "poseId,timestamp";
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            text.append(",T").append(std::to_string(row)).append(std::to_string(column));
    text += '\n';
    for (std::size_t i = 0; i < poses.size(); ++i) {
        text += std::to_string(i) + ',' + exactText(poses[i].time_s);
        for (const double value : rowMajor(poses[i].worldFromScanner)) text += ',' + exactText(value);
        text += '\n';
    }
    return writeTextFile(file, text);
}

}  // namespace vestige
