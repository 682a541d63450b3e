#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/Pose.h"

namespace vestige {

/// What is known about one picked end, along any direction: the standard uncertainty of the point.
struct EndUncertainty {
    double sensorNoise_m = 0;   ///< 1 sigma of the sensor that measured the point
    double localSpacing_m = 0;  ///< d; contributes d / sqrt(12)
    double standard_m() const;
};

/// One repetition: two ends in a common frame, metres.
struct EndPair {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
    double length_m() const { return (b - a).norm(); }
};

/// A measured length as a statistic (METHOD section 5).
struct LengthStatistic {
    std::vector<double> repeats_m;
    double mean_m = 0;
    std::optional<double> repeatSd_m;             ///< none with one repeat
    std::optional<double> standardUncertainty_m;  ///< u; none with one repeat
    std::optional<double> degreesOfFreedom;       ///< Welch-Satterthwaite nu of u; infinite when s = 0
    std::optional<double> coverageFactor;         ///< t(0.975, nu)
    std::optional<double> expandedUncertainty_m;  ///< U = t(0.975, nu) u
};

/// u^2 = s^2/n + u_a^2 + u_b^2 + u_r^2 (GUM). `registration_m` is u_r: the registration's share along the
/// length, 0 when both ends lie on one layer. Nothing without repeats.
std::optional<LengthStatistic> lengthStatistic(std::span<const double> repeats_m, const EndUncertainty& a,
                                               const EndUncertainty& b, double registration_m = 0);

/// Standard uncertainty of a length along `direction` between a point of a registered layer at `lever` (from
/// the centre of the rotation, target frame, metres) and one of the target, from the 6x6 covariance of (t,
/// rotation vector) of the pose.
double registrationShare(const Eigen::Matrix<double, 6, 6>& covariance, const Eigen::Vector3d& lever,
                         const Eigen::Vector3d& direction);

/// The two-sided 97.5 % point of Student's t for `degrees` of freedom (any real above 0, infinity included).
double studentQuantile975(double degrees);

/// RE = (measured - tape) / tape, signed. Nothing for a tape of 0.
std::optional<double> relativeError(double measured_m, double tape_m);

/// The tape's own standard uncertainty: its last digit / sqrt(12). `resolution_m` e.g. 0.01.
double tapeUncertainty(double resolution_m);

}  // namespace vestige
