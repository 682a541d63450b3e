#include "core/measurement/fit/Neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

bool isClipped(const std::vector<ClipPlane>& clips, const Eigen::Vector3d& world) {
    return std::any_of(clips.begin(), clips.end(),
                       [&](const ClipPlane& clip) { return clip.normal.dot(world) + clip.distance < 0; });
}

}  // namespace

double snapRadius_m(double sensorNoise_m, double localSpacing_m) {
    return std::max(6 * sensorNoise_m, 8 * localSpacing_m);
}

Neighbourhood Neighbourhood::within(const Eigen::Vector3d& centre, double radius) const {
    Neighbourhood part = *this;
    part.radius_m = radius;
    std::erase_if(part.points, [&](const FitPoint& point) {
        return (point.position - centre).squaredNorm() > radius * radius;
    });
    return part;
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
    found.hasTime = !attributes.gpsTime.empty();
    const double start = found.hasTime && !neighbours.empty() ? attributes.gpsTime[neighbours[0].point] : 0;
    found.points.reserve(neighbours.size());
    for (const Octree::Neighbour& neighbour : neighbours) {
        const Eigen::Vector3d world = request.sceneFromLayer * cloud.point(neighbour.point);
        if (isClipped(request.clips, world)) continue;
        FitPoint point{world - request.seed, 1, 0};
        if (found.hasEnergy) point.energy = static_cast<double>(attributes.intensity[neighbour.point]);
        if (found.hasTime) point.time_s = attributes.gpsTime[neighbour.point] - start;
        found.points.push_back(point);
    }
    if (found.points.empty()) return fail(ErrorCode::input, "there are no points round the pick");
    return found;
}

}  // namespace vestige
