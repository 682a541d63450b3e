#include "core/measurement/fit/Neighbourhood.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace vestige {
double snapRadius_m(double sensorNoise_m, double localSpacing_m) {
    return std::max(8 * sensorNoise_m, 8 * localSpacing_m);
}

Neighbourhood Neighbourhood::within(const Eigen::Vector3d& centre, double radius) const {
    Neighbourhood part = *this;
    part.radius_m = radius;
    std::erase_if(part.points, [&](const FitPoint& point) {
        return (point.position - centre).squaredNorm() > radius * radius;
    });
    return part;
}

double Neighbourhood::blur_m(const FitPoint& point, const Eigen::Vector3d& direction) const {
    if (point.range_m <= 0) return noise_m;
    constexpr double kHalfPower = 2.354820045;  // standard deviations in a Gaussian's width at half power
    const Eigen::Vector3d level = point.beam.cross(Eigen::Vector3d::UnitZ()).normalized();
    const Eigen::Vector3d upright = level.cross(point.beam);
    const double range = noise_m * point.beam.dot(direction);
    const double aside = point.range_m / kHalfPower * spotLevel_rad * level.dot(direction);
    const double above = point.range_m / kHalfPower * spotUpright_rad * upright.dot(direction);
    return std::sqrt(range * range + aside * aside + above * above);
}

Result<Neighbourhood> neighbourhoodOf(const SnapRequest& request, double widening) {
    if (!request.octree || request.octree->cloud().empty())
        return fail(ErrorCode::input, "there are no points to fit to");
    const Octree& octree = *request.octree;
    const PointCloud& cloud = octree.cloud();
    const Similarity layerFromScene = request.sceneFromLayer.inverse();
    const Eigen::Vector3f centre = (layerFromScene * request.seed - cloud.origin()).cast<float>();

    Neighbourhood found;
    found.noise_m = request.sensorNoise_m;
    found.view = request.viewDirection;
    std::vector<Octree::Neighbour> neighbours;
    octree.nearest(centre, 1, neighbours);
    found.spacing_m =
        request.sceneFromLayer.scale * static_cast<double>(octree.localSpacing(neighbours.front().point));
    found.radius_m = widening * (request.radius_m > 0 ? request.radius_m
                                                      : snapRadius_m(request.sensorNoise_m, found.spacing_m));
    octree.radiusSearch(centre, static_cast<float>(found.radius_m / request.sceneFromLayer.scale),
                        neighbours);

    const PointAttributes& attributes = cloud.attributes();
    found.hasEnergy = !attributes.intensity.empty();
    found.hasBeams = request.path && request.path->size() == cloud.size();
    found.spotUpright_rad = request.spotUpright_rad;
    found.spotLevel_rad = request.spotLevel_rad;
    found.points.reserve(neighbours.size());
    for (const Octree::Neighbour& neighbour : neighbours) {
        if (request.hidden && (*request.hidden)[neighbour.point]) continue;
        const Eigen::Vector3d world = request.sceneFromLayer * cloud.point(neighbour.point);
        if (!request.clips.keeps(world)) continue;
        FitPoint point{.position = world - request.seed};
        if (found.hasEnergy) point.energy = static_cast<double>(attributes.intensity[neighbour.point]);
        if (found.hasBeams) {
            if (const auto from = request.path->at(request.path->timeOf(neighbour.point))) {
                const Eigen::Vector3d beam = world - request.sceneFromLayer * *from;
                point.range_m = beam.norm();
                point.beam = beam / point.range_m;
            }
        }
        found.points.push_back(point);
    }
    if (found.points.empty()) return fail(ErrorCode::input, "there are no points round the pick");
    return found;
}

}  // namespace vestige
