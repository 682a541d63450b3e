#include "core/measurement/Length.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace vestige {
namespace {

double square(double x) {
    return x * x;
}

/// The standard uncertainty of a value that is only known to lie within +-width/2 (GUM 4.3.7).
double ofRectangle(double width) {
    return width / std::sqrt(12.0);
}

}  // namespace

double EndUncertainty::standard_m() const {
    return std::hypot(sensorNoise_m, ofRectangle(localSpacing_m));
}

std::optional<LengthStatistic> lengthStatistic(std::span<const double> repeats_m, const EndUncertainty& a,
                                               const EndUncertainty& b, double registration_m) {
    if (repeats_m.empty()) return std::nullopt;
    LengthStatistic result;
    result.repeats_m.assign(repeats_m.begin(), repeats_m.end());
    const auto n = static_cast<double>(repeats_m.size());
    double sum = 0;
    for (const double length : repeats_m) sum += length;
    result.mean_m = sum / n;
    if (repeats_m.size() < 2) return result;

    double squares = 0;
    for (const double length : repeats_m) squares += square(length - result.mean_m);
    result.repeatSd_m = std::sqrt(squares / (n - 1));

    const double ofMean = square(*result.repeatSd_m) / n;
    const double u2 = ofMean + square(a.standard_m()) + square(b.standard_m()) + square(registration_m);
    result.standardUncertainty_m = std::sqrt(u2);
    // Welch-Satterthwaite (GUM G.4.1): only s has finitely many degrees of freedom, so its term alone stands.
    result.degreesOfFreedom =
        ofMean > 0 ? (n - 1) * square(u2 / ofMean) : std::numeric_limits<double>::infinity();
    result.coverageFactor = studentQuantile975(*result.degreesOfFreedom);
    result.expandedUncertainty_m = *result.coverageFactor * *result.standardUncertainty_m;
    return result;
}

double registrationShare(const Eigen::Matrix<double, 6, 6>& covariance, const Eigen::Vector3d& lever,
                         const Eigen::Vector3d& direction) {
    const Eigen::Vector3d along = direction.normalized();
    // A rotation w moves the point by w x lever; along . (w x lever) = w . (lever x along).
    Eigen::Matrix<double, 6, 1> gradient;
    gradient << along, lever.cross(along);
    return std::sqrt(std::max(0.0, gradient.dot(covariance * gradient)));
}

std::optional<double> relativeError(double measured_m, double tape_m) {
    if (tape_m == 0) return std::nullopt;
    return (measured_m - tape_m) / tape_m;
}

double tapeUncertainty(double resolution_m) {
    return ofRectangle(resolution_m);
}

}  // namespace vestige
