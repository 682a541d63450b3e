#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/measurement/fit/Neighbourhood.h"
#include "core/measurement/fit/PlaneFit.h"

namespace vestige {

/// A straight edge, from the neighbourhood's seed, m.
struct LineFit {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the line, nearest to where the view passes
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the line's place at `point`, across it
    double slope = 0;                                      ///< standard uncertainty of the direction, rad
    double rms = 0;
    std::size_t inliers = 0;
};

/// The line where two planes of the neighbourhood meet. Each is fitted once more to the points of its own
/// side that are farther from the line than `clear_m`: nearer ones are mixed of both. Nothing where the
/// planes are within 20 degrees of each other, or where one of them does not reach the line near the seed.
std::optional<LineFit> creaseOf(const Neighbourhood& near, const PlaneFit& a, const PlaneFit& b,
                                double clear_m);

/// Where the plane's points end near the seed. The share of the beam that still met the plane (energy) is
/// summed outwards from well within, over columns along the edge; the sum over the density within is the
/// width that is left, whatever the shape of the beam. Nothing where the plane has no straight end there.
std::optional<LineFit> boundaryOf(const Neighbourhood& near, const PlaneFit& plane, double clear_m);

/// The crease or boundary nearest to where the view passes the seed.
std::optional<LineFit> edgeAtSeed(const Neighbourhood& near);

/// Of the line through `point` along `direction`, the place nearest to the line of sight through the seed.
Eigen::Vector3d nearestToView(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                              const Eigen::Vector3d& view);

}  // namespace vestige
