#include "core/survey/CircularFlight.h"

#include <cmath>
#include <numbers>

namespace vestige {

Pose CircularFlight::siteFromSensor(double t_s) const {
    const double angle = startAngle_rad + 2 * std::numbers::pi * t_s / secondsPerCircle;
    const Eigen::Vector3d position =
        target + Eigen::Vector3d(radius_m * std::cos(angle), radius_m * std::sin(angle), height_m);
    const Eigen::Vector3d forward = (target - position).normalized();
    const Eigen::Vector3d left(std::sin(angle), -std::cos(angle), 0);
    Pose pose = Pose::Identity();
    pose.linear() << forward, left, forward.cross(left);
    pose.translation() = position;
    return pose;
}

}  // namespace vestige
