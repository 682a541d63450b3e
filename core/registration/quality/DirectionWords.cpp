#include "core/registration/quality/DirectionWords.h"

#include <array>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Units.h"

namespace vestige {
namespace {

constexpr double kSteep = 0.8;  // of a unit vector's z: within 37 degrees of the vertical
constexpr double kLevel = 0.35;

/// "roughly east-west (84° from the y axis)" of a line; both its ends are the same.
std::string bearing(const Eigen::Vector3d& line) {
    double angle = degrees(std::atan2(line.x(), line.y()));
    if (angle < 0) angle += 180;
    if (angle >= 180) angle -= 180;
    constexpr std::array names{"north-south", "northeast-southwest", "east-west", "southeast-northwest",
                               "north-south"};
    const auto nearest = static_cast<std::size_t>(std::lround(angle / 45));
    return std::string("roughly ") + names[nearest] + " (" + fixedText(angle, 0) + "\u00b0 from the y axis)";
}

std::string slideWords(const Eigen::Vector3d& shift) {
    const double z = std::abs(shift.normalized().z());
    if (z > kSteep) return "moves up and down";
    return (z < kLevel ? "slides level " : "slides at a slope ") + bearing(shift);
}

std::string turnWords(const Eigen::Vector3d& axis) {
    const double z = std::abs(axis.normalized().z());
    if (z > kSteep) return "turns about the vertical axis";
    return (z < kLevel ? "tilts about a level axis that runs " : "turns about a sloping axis that runs ") +
           bearing(axis);
}

}  // namespace

std::string motionWords(const Vector6d& motion) {
    constexpr double kSecond = 0.3;
    const double shift = motion.head<3>().squaredNorm();
    const double turn = motion.tail<3>().squaredNorm();
    if (!(shift + turn > 0)) return "does not move";
    const double turning = turn / (shift + turn);
    if (turning < kSecond) return slideWords(motion.head<3>());
    if (turning > 1 - kSecond) return turnWords(motion.tail<3>());
    return slideWords(motion.head<3>()) + " and " + turnWords(motion.tail<3>());
}

}  // namespace vestige
