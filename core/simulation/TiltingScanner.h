#pragma once

#include <cstdint>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/Pose.h"
#include "core/simulation/RayTracer.h"
#include "core/survey/Sensors.h"

namespace vestige {

/// One range as the scanner stores it.
struct TiltedPoint {
    Eigen::Vector3d position;  ///< scanner's frame: x forward, y left, z up, metres
    float intensity = 0;
    double time_s = 0;       ///< since the scan began
    std::uint16_t line = 0;  ///< of the tilt
    std::uint16_t beam = 0;  ///< within the line
};

struct TiltingOptions {
    Pose worldFromScanner = Pose::Identity();
    std::size_t beams = 65000;  ///< sent out in the whole scan, about
    double tiltFrom_rad = -0.70;
    double tiltTo_rad = 1.22;     ///< positive: the front of the plane looks up
    double falseRanges = 0.0008;  ///< share of beams that answer from anywhere
    std::uint64_t seed = 1;
    std::uint64_t number = 0;  ///< of the scan, for its random numbers
};

/// A scan that stands still while the plane of a range finder tilts about the scanner's y axis: lines from
/// tiltFrom to tiltTo, in each line beams over the sheet's field of view at the same angular step. A beam is
/// a bundle of rays; those whose ranges lie within the sheet's resolution of each other make one range, and
/// the strongest of these answers, so that points float at edges. Range noise on every answer. The same for
/// any number of threads. Errors: cancelled.
Result<std::vector<TiltedPoint>> scanTilting(const RayTracer& tracer, const SurfaceModel& surfaces,
                                             const TiltingLidarSheet& sheet, const TiltingOptions& options,
                                             const JobControl& control);

}  // namespace vestige
