#pragma once

#include <cstdint>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"
#include "core/simulation/Probes.h"
#include "core/simulation/RayTracer.h"
#include "core/simulation/SceneSpec.h"
#include "core/survey/Sensors.h"

namespace vestige {

struct HandheldScan {
    PointCloud cloud;           ///< the scanner's own frame, millimetres
    Similarity siteFromLayer;   ///< the truth: site metres from the cloud's millimetres
    std::vector<Probe> sample;  ///< some of the scanned places, spread over the scan
    std::vector<std::uint32_t> probeCounts;
};

/// Sweeps the handheld scanner: every shot is a raster of rays with the layer's spacing in its middle; a ray
/// counts within the sheet's working depth, on surfaces that are not too steep and not glass; noise along the
/// ray. Shots are fused to one point per spacing, and the whole stands in a frame of its own (the seed's
/// rotation and shift). Errors: cancelled; ErrorCode::input when nothing was hit.
Result<HandheldScan> scanByHand(const RayTracer& tracer, const SurfaceModel& surfaces,
                                const HandheldSheet& sheet, const HandheldSpec& layer,
                                const Pose& siteFromObject, std::uint64_t seed, const ProbeCounter& probes,
                                const JobControl& control);

}  // namespace vestige
