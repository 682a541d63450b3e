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
    double time_s = 0;  ///< of the pulse; 0 where the cloud has none
};

/// The points round a seed, ascending by index in the cloud.
struct Neighbourhood {
    std::vector<FitPoint> points;
    double radius_m = 0;
    double spacing_m = 0;                              ///< local spacing at the seed
    double noise_m = 0;                                ///< 1 sigma of a point, along its beam
    Eigen::Vector3d view = -Eigen::Vector3d::UnitZ();  ///< unit, from the eye
    bool hasEnergy = false;
    bool hasTime = false;

    /// The part within `radius_m` of `centre` (from the seed).
    Neighbourhood within(const Eigen::Vector3d& centre, double radius_m) const;
};

/// What a request asks for, with its radius times `widening`. ErrorCode::input when no points are there.
Result<Neighbourhood> neighbourhoodOf(const SnapRequest& request, double widening = 1);

}  // namespace vestige
