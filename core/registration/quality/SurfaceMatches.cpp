#include "core/registration/quality/SurfaceMatches.h"

#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr double kParallel = 0.85;  // cosine: 32 degrees

SurfaceMatch matched(const SurfaceCell& cell, const Pose& pose, const SurfaceIndex& other,
                     double tolerance_m) {
    SurfaceMatch match;
    match.place = pose * cell.mean;
    match.normal = pose.linear() * cell.normal;
    match.other = other.over(match.place, match.normal, kParallel);
    if (!match.other) {
        match.other = other.over(match.place, match.normal, 0);
        match.state = match.other ? SurfaceState::conflicts : SurfaceState::unseen;
        return match;
    }
    const Eigen::Vector3d offset = match.place - match.other->mean;
    match.distance_m = offset.dot(match.other->normal);
    match.predicted_m =
        std::sqrt(match.other->planeVariance(offset) + cell.thickness_m * cell.thickness_m / cell.count);
    match.state = std::abs(match.distance_m) <= tolerance_m ? SurfaceState::agrees : SurfaceState::conflicts;
    return match;
}

}  // namespace

std::vector<SurfaceMatch> matchSurfaces(const std::vector<SurfaceCell>& cells, const Pose& pose,
                                        const SurfaceIndex& other, double tolerance_m) {
    std::vector<SurfaceMatch> matches(cells.size());
    parallelFor(cells.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            matches[i] = matched(cells[i], pose, other, tolerance_m);
            matches[i].cell = static_cast<std::uint32_t>(i);
        }
    });
    return matches;
}

}  // namespace vestige
