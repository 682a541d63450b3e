#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>

#include "core/geometry/Pose.h"

namespace vestige {

/// What a pick means: the measured point itself, or a feature fitted to its neighbourhood.
enum class SnapMode { point, plane, edge, corner, highest, lowest, circle, centroid, surface };
std::string_view name(SnapMode mode);
std::optional<SnapMode> snapModeFromName(std::string_view name);

/// A feature fitted to the points round a pick, in the frame and unit of its owner.
struct FittedFeature {
    SnapMode mode = SnapMode::plane;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< where on it the pick is
    /// Unit: a plane's normal, an edge's direction, a circle's axis; zero for the others.
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of `position`
    double axisUncertainty = 0;                            ///< standard, rad, of `axis`
    double radius = 0;                                     ///< of a circle
    double radiusUncertainty = 0;                          ///< standard
    double rms = 0;                                        ///< of the inliers' residuals
    std::size_t inliers = 0;

    friend bool operator==(const FittedFeature&, const FittedFeature&) = default;
};

/// The feature in another frame and unit.
FittedFeature moved(const FittedFeature& feature, const Similarity& toFromHere);

}  // namespace vestige
