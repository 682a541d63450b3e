#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/measurement/fit/Neighbourhood.h"

namespace vestige {

/// A plane fitted to points, from the neighbourhood's seed, m.
struct PlaneFit {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< weighted mean of its points
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: two directions in the plane, the normal
    Eigen::Vector3d variance =
        Eigen::Vector3d::Zero();  ///< of the slopes along the two axes, and of the offset
    double rms = 0;               ///< of the inliers' distances
    std::size_t inliers = 0;
    double support = 0;  ///< sum of the inliers' weights

    double distance(const Eigen::Vector3d& point) const { return normal.dot(point - centre); }
    Eigen::Vector3d project(const Eigen::Vector3d& point) const { return point - distance(point) * normal; }
    /// Variance of the plane's height at `point`, m2.
    double varianceAt(const Eigen::Vector3d& point) const;
};

/// Tukey's biweight of a residual over a scale; 0 from 4.685 scales on.
double tukeyWeight(double residual, double scale);

/// Scale of residuals whose middle is 0: the median of their magnitudes times 1.4826; 0 for none.
double robustScale(std::vector<double> residuals);

/// The least-squares plane of points with weights (none: all 1), refined from `start` with Tukey's biweight
/// (ending at 3.2 scales) until it settles. `noise_m`: the largest scale that residuals are judged by; 0.4 of
/// it the least. Nothing with fewer than 6
/// inliers or where these lie on a line.
std::optional<PlaneFit> refinePlane(std::span<const FitPoint> points, const PlaneFit& start, double noise_m);

/// The planes that the points of a neighbourhood lie on, strongest first, at most `most`: directions over
/// the half sphere, for each the offset that most points agree on, refined; what lies on one is taken away
/// before the next is sought. Planes with less than `leastShare` of the points are left out.
std::vector<PlaneFit> findPlanes(const Neighbourhood& near, std::size_t most, double leastShare = 0.08);

/// The plane at the seed: among those found the one most points of which lie round where the view meets it.
std::optional<PlaneFit> planeAtSeed(const Neighbourhood& near);

}  // namespace vestige
