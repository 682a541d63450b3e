#pragma once

#include <string_view>

namespace vestige {

/// What an airborne laser scanner's data sheet says; metres, radians, seconds. Full angles, one sigma.
struct AirborneLidarSheet {
    std::string_view name;
    double pulsesPerSecond;
    double rangeNoise_m;
    double divergenceLong_rad;   ///< full width at half power, along the longer side of the spot
    double divergenceShort_rad;  ///< the same across
    double fieldHorizontal_rad;
    double fieldVertical_rad;            ///< non-repetitive pattern
    double fieldVerticalRepetitive_rad;  ///< line pattern
    int maxReturns;
    double rangeAtTenPercent_m;  ///< farthest range of a target that reflects 10 %
    double positionHorizontal_m;
    double positionVertical_m;
    double rollPitch_rad;  ///< after post-processing
    double yaw_rad;        ///< after post-processing
    /// Echoes nearer to each other than this become one. Not on the sheet; see docs/simulation.md.
    double rangeResolution_m;
};

/// What a handheld scanner's data sheet says.
struct HandheldSheet {
    std::string_view name;
    double noise_m;
    double workingDistance_m;
    double depthOfField_m;
    double steepest_rad;  ///< surfaces seen at a larger angle from their normal give no data
};

/// DJI Zenmuse L1 on an M300 RTK (maker's sheet; METHOD section 1).
const AirborneLidarSheet& zenmuseL1();
/// Shining 3D EinScan Pro 2X, handheld rapid scan (maker's sheet; METHOD section 1).
const HandheldSheet& einScanPro2X();

}  // namespace vestige
