#include "core/measurement/fit/Snap.h"

#include <cmath>
#include <string>

#include "core/measurement/fit/CircleFit.h"
#include "core/measurement/fit/EdgeFit.h"
#include "core/measurement/fit/PlaneFit.h"
#include "core/measurement/fit/PointFits.h"
#include "core/measurement/fit/SurfaceFit.h"

namespace vestige {
namespace {

tl::unexpected<Error> none(const std::string& what, const Neighbourhood& near) {
    return fail(ErrorCode::input, "no " + what + " was found round the pick",
                std::to_string(near.points.size()) + " points within " +
                    std::to_string(static_cast<int>(std::lround(1000 * near.radius_m))) + " mm",
                "pick nearer to it, or choose another feature");
}

/// How deep behind the seed, along the view, what is seen there lies: the mean over the points beside the
/// line of sight, those of deeper surfaces left out.
struct Depth {
    double mean = 0;
    double variance = 0;
    std::size_t count = 0;
};

std::optional<Depth> frontDepth(const Neighbourhood& near) {
    const double beside = std::max(near.noise_m, 2 * near.spacing_m);
    Depth depth;
    for (int round = 0; round < 4; ++round) {
        double sum = 0;
        depth.count = 0;
        for (const FitPoint& point : near.points) {
            const double at = near.view.dot(point.position);
            if ((point.position - at * near.view).norm() > beside) continue;
            if (std::abs(at - depth.mean) > 2.5 * near.noise_m) continue;
            sum += at;
            ++depth.count;
        }
        if (depth.count < 5) return std::nullopt;
        depth.mean = sum / static_cast<double>(depth.count);
    }
    depth.variance = near.noise_m * near.noise_m / static_cast<double>(depth.count);
    return depth;
}

/// A surface too small or too round for a plane of its own, taken as facing the viewer.
FittedFeature facing(const Neighbourhood& near, const Depth& depth) {
    FittedFeature feature{.mode = SnapMode::plane};
    feature.position = depth.mean * near.view;
    feature.axis = -near.view;
    feature.axisUncertainty = 0.5;
    const double aside = near.spacing_m * near.spacing_m / 12;
    feature.covariance =
        aside * Eigen::Matrix3d::Identity() + (depth.variance - aside) * near.view * near.view.transpose();
    feature.rms = near.noise_m;
    feature.inliers = depth.count;
    return feature;
}

Result<FittedFeature> plane(const Neighbourhood& near) {
    constexpr double kFacing = 0.7;
    const auto fit = planeAtSeed(near);
    const auto depth = frontDepth(near);
    if (!fit) return depth ? Result<FittedFeature>(facing(near, *depth)) : none("plane", near);
    FittedFeature feature{.mode = SnapMode::plane};
    const double slant = fit->normal.dot(near.view);
    feature.position = fit->project(Eigen::Vector3d::Zero());
    // Where the line of sight meets it, unless the plane is seen too much from the side for that.
    if (std::abs(slant) > 0.3) feature.position = fit->distance(Eigen::Vector3d::Zero()) / -slant * near.view;
    // A handle stands before its door, a mirror before what is behind it: the plane of the larger is not
    // what was clicked.
    if (depth && std::abs(slant) > kFacing) {
        const double behind = near.view.dot(feature.position) - depth->mean;
        if (behind * behind > 4 * (depth->variance + fit->varianceAt(feature.position)))
            return facing(near, *depth);
    }
    feature.axis = slant > 0 ? Eigen::Vector3d(-fit->normal) : fit->normal;
    feature.axisUncertainty = std::sqrt(std::max(fit->variance[0], fit->variance[1]));
    const double aside = near.spacing_m * near.spacing_m / 12;
    feature.covariance = aside * Eigen::Matrix3d::Identity() +
                         (fit->varianceAt(feature.position) - aside) * fit->normal * fit->normal.transpose();
    feature.rms = fit->rms;
    feature.inliers = fit->inliers;
    return feature;
}

Result<FittedFeature> edge(const Neighbourhood& near) {
    const auto fit = edgeAtSeed(near);
    if (!fit) return none("edge", near);
    FittedFeature feature{.mode = SnapMode::edge};
    feature.position = fit->point;
    feature.axis = fit->direction;
    feature.axisUncertainty = fit->slope;
    feature.covariance = fit->covariance;
    feature.rms = fit->rms;
    feature.inliers = fit->inliers;
    return feature;
}

Result<FittedFeature> circle(const Neighbourhood& near) {
    const auto fit = circleAtSeed(near);
    if (!fit) return none("circle", near);
    FittedFeature feature{.mode = SnapMode::circle};
    feature.position = fit->centre;
    feature.axis = fit->axis.dot(near.view) > 0 ? Eigen::Vector3d(-fit->axis) : fit->axis;
    feature.axisUncertainty = fit->axisUncertainty;
    feature.covariance = fit->covariance;
    feature.radius = fit->radius;
    feature.radiusUncertainty = fit->radiusUncertainty;
    feature.rms = fit->rms;
    feature.inliers = fit->inliers;
    return feature;
}

Result<FittedFeature> place(SnapMode mode, const Neighbourhood& near) {
    std::optional<PlaceFit> fit;
    if (mode == SnapMode::corner) fit = cornerAtSeed(near);
    if (mode == SnapMode::highest) fit = extremeAlong(near, Eigen::Vector3d::UnitZ());
    if (mode == SnapMode::lowest) fit = extremeAlong(near, -Eigen::Vector3d::UnitZ());
    if (mode == SnapMode::centroid) fit = centroidAtSeed(near);
    if (mode == SnapMode::surface) fit = surfaceAtSeed(near);
    if (!fit) return none(std::string(name(mode)), near);
    FittedFeature feature{.mode = mode};
    feature.position = fit->place;
    // The line of sight, towards the viewer: what is not known of the depth lies along it.
    if (mode == SnapMode::surface) feature.axis = -near.view;
    feature.covariance = fit->covariance;
    feature.rms = fit->rms;
    feature.inliers = fit->inliers;
    return feature;
}

/// A wheel has its rim about the pick; two or three faces look like one bevelled plane unless they are seen
/// farther out than the noise.
double wideningOf(SnapMode mode) {
    switch (mode) {
        case SnapMode::circle:
            return 3;
        case SnapMode::corner:
            return 2;
        case SnapMode::edge:
            return 1.25;
        default:
            return 1;
    }
}

Result<FittedFeature> fitAt(const Neighbourhood& near, SnapMode mode) {
    switch (mode) {
        case SnapMode::plane:
            return plane(near);
        case SnapMode::edge:
            return edge(near);
        case SnapMode::circle:
            return circle(near);
        case SnapMode::point:
        case SnapMode::corner:
        case SnapMode::highest:
        case SnapMode::lowest:
        case SnapMode::centroid:
        case SnapMode::surface:
            break;
    }
    return place(mode, near);
}

}  // namespace

Result<FittedFeature> snapFeature(const SnapRequest& request, SnapMode mode) {
    if (mode == SnapMode::point) {
        FittedFeature feature{.mode = mode, .position = request.seed};
        feature.covariance = request.sensorNoise_m * request.sensorNoise_m * Eigen::Matrix3d::Identity();
        feature.inliers = 1;
        return feature;
    }
    return guarded("fitting", [&]() -> Result<FittedFeature> {
        const auto near = neighbourhoodOf(request, request.radius_m > 0 ? 1 : wideningOf(mode));
        if (!near) return fail(near.error());
        auto feature = fitAt(*near, mode);
        if (feature) feature->position += request.seed;
        return feature;
    });
}

}  // namespace vestige
