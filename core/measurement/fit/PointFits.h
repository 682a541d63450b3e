#pragma once

#include <optional>

#include "core/measurement/fit/EdgeFit.h"
#include "core/measurement/fit/Neighbourhood.h"

namespace vestige {

/// A fitted place, from the neighbourhood's seed, m.
struct PlaceFit {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double rms = 0;
    std::size_t inliers = 0;
};

/// Where three planes of the neighbourhood meet, nearest to the seed; nothing where no three do.
std::optional<PlaceFit> cornerAtSeed(const Neighbourhood& near);

/// The end of the points along `upwards` (unit), robust against noise and strays: see upperEnd. Its place
/// across `upwards` is the middle of the points at that end.
std::optional<PlaceFit> extremeAlong(const Neighbourhood& near, const Eigen::Vector3d& upwards);

/// The mean of the points within the radius, those far from the rest left out.
std::optional<PlaceFit> centroidAtSeed(const Neighbourhood& near);

}  // namespace vestige
