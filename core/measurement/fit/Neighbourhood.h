#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/measurement/fit/Snap.h"

namespace vestige {

/// A point that a feature is fitted to.
struct FitPoint {
    Eigen::Vector3d position;  ///< scene axes, m, from the seed
    /// Share of the neighbourhood's usual intensity; 1 where the cloud has none. A beam that hits a surface
    /// with half of its spot answers with half.
    double energy = 1;
    Eigen::Vector3d beam = Eigen::Vector3d::Zero();  ///< unit, from the scanner; zero: not known
    double range_m = 0;                              ///< from the scanner; 0: not known
};

/// The points round a seed, ascending by index in the cloud.
struct Neighbourhood {
    std::vector<FitPoint> points;
    double radius_m = 0;
    double spacing_m = 0;                              ///< local spacing at the seed
    double noise_m = 0;                                ///< 1 sigma of a point, along its beam
    Eigen::Vector3d view = -Eigen::Vector3d::UnitZ();  ///< unit, from the eye
    bool hasEnergy = false;
    bool hasBeams = false;
    double spotUpright_rad = 0;
    double spotLevel_rad = 0;

    /// Standard deviation along `direction` (unit) of where the point lies: noise along its beam, half
    /// widths of its spot across. The noise alone where the beam is not known.
    double blur_m(const FitPoint& point, const Eigen::Vector3d& direction) const;

    /// The part within `radius_m` of `centre` (from the seed).
    Neighbourhood within(const Eigen::Vector3d& centre, double radius_m) const;
};

/// What a request asks for, with its radius times `widening`. ErrorCode::input when no points are there.
Result<Neighbourhood> neighbourhoodOf(const SnapRequest& request, double widening = 1);

}  // namespace vestige
