#pragma once

#include <Eigen/Core>

#include "core/measurement/FittedFeature.h"

namespace vestige {

/// One end of a length: what was fitted, and the point that was picked. One frame, metres.
struct FittedEnd {
    Eigen::Vector3d pick = Eigen::Vector3d::Zero();
    FittedFeature feature;
};

/// A length between two fitted features.
struct FittedLength {
    double length_m = 0;
    double variance_m2 = 0;                       ///< from the covariances of the two fits
    Eigen::Vector3d a = Eigen::Vector3d::Zero();  ///< where it begins and ends, to draw it
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

/// What the two features mean as a length:
/// - two picks on one circle (its centre found within a fifth of the radius, axes within 20 degrees): the
///   diameter, the mean of the two fits, which share their points and so their error;
/// - a circle and something else: from the place on the rim that was picked, which is the circle's far or
///   near end as seen from the other feature, or from the centre where the pick is nearer to that;
/// - two edges within 15 degrees of each other: their distance at right angles to both;
/// - two planes within 15 degrees: their distance along the common normal where the normals are known well
///   enough for it, else along the line between the two places (whichever is surer);
/// - two places on planes that the length lies in: the straight distance, uncertain by what a depth wrong at
///   both ends by the noise makes of it, seen from 2 m;
/// - two places on the surface seen: the straight distance; a depth wrong at both ends by the noise makes
///   it uncertain by as much as the two lines of sight part;
/// - else the straight distance.
FittedLength fittedLength(const FittedEnd& a, const FittedEnd& b);

}  // namespace vestige
