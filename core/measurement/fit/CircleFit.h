#pragma once

#include <optional>

#include "core/measurement/fit/Neighbourhood.h"

namespace vestige {

/// A circle, from the neighbourhood's seed, m.
struct CircleFit {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double radius = 0;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the centre
    double radiusUncertainty = 0;                          ///< standard
    double axisUncertainty = 0;                            ///< standard, rad
    double rms = 0;                                        ///< of the rim's points, across it
    std::size_t inliers = 0;
};

/// A ring (a rim, a thin wheel, the top of a pipe) or the outline of a disc in the plane of the seed. Rings:
/// the circle that most points of the plane lie on, refined by least squares with Tukey's biweight on radial
/// distances. Discs: the same on the ends of their points, sector by sector. Nothing where less than a third
/// of the turn is seen or where a third of the plane's points near the rim contradict it.
std::optional<CircleFit> circleAtSeed(const Neighbourhood& near);

}  // namespace vestige
