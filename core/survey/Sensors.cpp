#include "core/survey/Sensors.h"

#include "core/base/Units.h"

namespace vestige {

const AirborneLidarSheet& zenmuseL1() {
    static const AirborneLidarSheet sheet{.name = "DJI Zenmuse L1",
                                          .pulsesPerSecond = 240000,
                                          .rangeNoise_m = 0.03,
                                          .divergenceLong_rad = radians(0.28),
                                          .divergenceShort_rad = radians(0.03),
                                          .fieldHorizontal_rad = radians(70.4),
                                          .fieldVertical_rad = radians(77.2),
                                          .fieldVerticalRepetitive_rad = radians(4.5),
                                          .maxReturns = 3,
                                          .rangeAtTenPercent_m = 190,
                                          .positionHorizontal_m = 0.010,
                                          .positionVertical_m = 0.015,
                                          .rollPitch_rad = radians(0.025),
                                          .yaw_rad = radians(0.08),
                                          .rangeResolution_m = 0.15};
    return sheet;
}

const HandheldSheet& einScanPro2X() {
    static const HandheldSheet sheet{.name = "Shining 3D EinScan Pro 2X",
                                     .noise_m = 0.0001,
                                     .workingDistance_m = 0.51,
                                     .depthOfField_m = 0.30,
                                     .steepest_rad = radians(75)};
    return sheet;
}

const TiltingLidarSheet& hokuyoUtm30Lx() {
    static const TiltingLidarSheet sheet{.name = "Hokuyo UTM-30LX",
                                         .fieldOfView_rad = radians(270),
                                         .linesPerSecond = 40,
                                         .nearest_m = 0.1,
                                         .farthest_m = 30,
                                         .noiseNear_m = 0.010,
                                         .noiseFar_m = 0.030,
                                         .nearEnd_m = 10,
                                         .divergence_rad = radians(0.76),
                                         .rangeResolution_m = 0.4,
                                         .leastReflectance = 0.2};
    return sheet;
}

}  // namespace vestige
