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

/// What the data sheet of a scanning laser range finder says that is tilted to see in three dimensions. Full
/// angles, one sigma.
struct TiltingLidarSheet {
    std::string_view name;
    double fieldOfView_rad;  ///< of the scanned plane, symmetrical to its front
    double linesPerSecond;
    double nearest_m;
    double farthest_m;
    double noiseNear_m;  ///< up to nearEnd_m
    double noiseFar_m;   ///< at farthest_m, growing in between
    double nearEnd_m;
    double divergence_rad;     ///< full width of the beam at half power
    double rangeResolution_m;  ///< surfaces nearer to each other than this give one range between them
    double leastReflectance;   ///< that answers at farthest_m; falls with the square of the range
};

/// DJI Zenmuse L1 on an M300 RTK (maker's sheet; METHOD section 1).
const AirborneLidarSheet& zenmuseL1();
/// Shining 3D EinScan Pro 2X, handheld rapid scan (maker's sheet; METHOD section 1).
const HandheldSheet& einScanPro2X();
/// Hokuyo UTM-30LX (maker's sheet; the range resolution is assumed, see docs/simulation.md).
const TiltingLidarSheet& hokuyoUtm30Lx();

}  // namespace vestige
