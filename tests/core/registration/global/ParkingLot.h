#pragma once

#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige::test {

/// Noisy points on 40 x 40 m of ground with kerb, van, wall and poles, and the same car at each of `cars`.
PointCloud parkingLot(const std::vector<Pose>& cars);

/// A dense scan of the car's front half, in the car's frame, metres.
PointCloud carFront();

/// A rotation from all rotations, and some shift.
Pose anyPose(std::uint64_t seed);

}  // namespace vestige::test
