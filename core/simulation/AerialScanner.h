#pragma once

#include <cstdint>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"
#include "core/simulation/Probes.h"
#include "core/simulation/RayTracer.h"
#include "core/survey/CircularFlight.h"
#include "core/survey/Sensors.h"

namespace vestige {

struct AerialOptions {
    CircularFlight flight;
    double seconds = 40;
    bool repetitive = false;
    std::uint64_t seed = 1;
    Eigen::Vector3d worldFromSite = Eigen::Vector3d::Zero();  ///< added to every point
    double gpsTime_s = 0;                                     ///< at t = 0
};

struct AerialScan {
    PointCloud cloud;  ///< world; intensity 0-255, GPS time, return number and count
    std::vector<std::uint32_t> probeCounts;
    std::uint64_t pulses = 0;
};

/// Flies the airborne scanner: pulses at the sheet's rate in its pattern, echoes by Footprint, range noise
/// per echo, and slow errors of position and attitude as post-processing leaves them. The same for any number
/// of threads. Error: cancelled.
Result<AerialScan> scanFromAir(const RayTracer& tracer, const SurfaceModel& surfaces,
                               const AirborneLidarSheet& sheet, const AerialOptions& options,
                               const ProbeCounter& probes, const JobControl& control);

/// Direction of the pulse at time t in the sensor's frame (x boresight, y left, z up), unit length.
Eigen::Vector3d beamDirection(const AirborneLidarSheet& sheet, bool repetitive, double t_s);

}  // namespace vestige
