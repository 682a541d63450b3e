#pragma once

#include <cstdint>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"
#include "core/simulation/Probes.h"
#include "core/simulation/RayTracer.h"
#include "core/survey/CircularFlight.h"

namespace vestige {

struct PhotogrammetryScan {
    PointCloud cloud;          ///< world as the software believes it; metres, colours
    Similarity siteFromLayer;  ///< the truth: site metres from the cloud's coordinates
    std::vector<std::uint32_t> probeCounts;
};

/// The cloud that image matching makes of night photographs from the same circle: a place needs three
/// photographs that see it, light, and texture; ranges carry an error that neighbours share (a matching
/// window sees one surface), bleed over edges by the window, and the whole has an error of scale and position
/// from the weak self-calibration at night. Model and figures: docs/simulation.md. Error: cancelled.
Result<PhotogrammetryScan> photographScene(const RayTracer& tracer, const SurfaceModel& surfaces,
                                           const CircularFlight& flight, const ParameterSet& parameters,
                                           const Eigen::Vector3d& worldFromSite, std::uint64_t seed,
                                           const ProbeCounter& probes, const JobControl& control);

}  // namespace vestige
