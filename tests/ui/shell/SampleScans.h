#pragma once

#include <Eigen/Core>
#include <filesystem>

namespace vestige::test {

/// Two small scans of one yard, written as text files: ground, two walls and a box of 2.0 x 1.0 x 0.8 m whose
/// corner `kBoxCorner` and the next ones along x and y are measured. The second scan is moved by a known,
/// small pose.
struct SampleScans {
    std::filesystem::path target;
    std::filesystem::path source;
};
SampleScans writeSampleScans(const std::filesystem::path& folder);

/// Something that stands nowhere in the yard: a ball of 0.4 m radius, two metres above its ground.
std::filesystem::path writeBall(const std::filesystem::path& folder);

/// Upper corners of the box, in the target's frame.
inline const Eigen::Vector3d kBoxCorner{-1.0, -0.5, 0.8};
inline const Eigen::Vector3d kBoxCornerAlongX{1.0, -0.5, 0.8};
/// How far the source was moved along x.
inline constexpr double kMoved_m = 0.25;

}  // namespace vestige::test
