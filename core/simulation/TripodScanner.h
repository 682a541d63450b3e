#pragma once

#include <cstddef>
#include <cstdint>

#include "core/geometry/PointCloud.h"
#include "core/geometry/Pose.h"
#include "core/simulation/TripodScene.h"

namespace vestige {

/// A levelled laser scanner on a tripod that turns once: rays at equal steps of azimuth and elevation, each
/// moved at random within its step, so that no two stations sample the same place.
struct TripodStation {
    Pose siteFromScanner = Pose::Identity();
    std::size_t points = 60000;   ///< wanted; reached to about 2 %
    double rangeNoise_m = 0.003;  ///< 1 sigma, along the ray
    double nearest_m = 0.6;
    double farthest_m = 60;
    double lowest_rad = -1.05;  ///< elevation of the lowest ray
    double highest_rad = 0.80;  ///< and of the highest
    std::uint64_t seed = 1;     ///< of the rays' jitter and the noise
};

/// The points in the scanner's own frame, metres. The same for any number of threads.
PointCloud scanFromTripod(const TripodScene& scene, const TripodStation& station);

}  // namespace vestige
