#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/geometry/PointCloud.h"

namespace vestige::test {

/// A tripod scanner that turns once: rings of points on what it sees.
struct Station {
    Pose worldFromScanner = Pose::Identity();
    double noise_m = 0.003;  ///< of a range, 1 sigma
    int rings = 64;
    int perRing = 900;
    std::uint64_t seed = 1;
};

/// What a scanner sees of a made-up street: ground, facades, parked cars, poles. Points in the scanner's
/// frame, so the pose between two stations is known exactly.
PointCloud scanStreet(const Station& station);

/// Random points on a car-like body of boxes, `density` per square metre, without noise; metres, the body
/// about 4.5 m long round the origin.
PointCloud carSurface(double density, double noise_m, std::uint64_t seed);

/// Angle of R(a)' R(b) in degrees, and the distance that a and b put the point apart.
double turnBetween(const Pose& a, const Pose& b);
double distanceAt(const Pose& a, const Pose& b, const Eigen::Vector3d& point);

}  // namespace vestige::test
