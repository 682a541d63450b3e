#pragma once

#include <Eigen/Core>

#include "core/geometry/Pose.h"

namespace vestige {

/// A circle flown round a target with the sensor kept on it: METHOD section 1, the flight for sites up to 50
/// m. Metres and seconds in the site's frame, z up.
struct CircularFlight {
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    double radius_m = 10;
    double height_m = 15;  ///< above the target
    double secondsPerCircle = 40;
    double startAngle_rad = 0;  ///< from x towards y

    /// The sensor at time t: x forward along its boresight, y to its left, z up in its own body.
    Pose siteFromSensor(double t_s) const;
};

}  // namespace vestige
