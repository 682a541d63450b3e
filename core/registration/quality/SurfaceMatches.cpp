#include "core/registration/quality/SurfaceMatches.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr double kParallel = 0.85;  // cosine: 32 degrees

/// Thick pieces, of twigs or of what smaller ones left, are not the same plane from two places.
SurfaceState disagreement(const SurfaceCell& cell, const SurfaceCell& other, double tolerance_m) {
    return std::max(cell.thickness_m, other.thickness_m) > tolerance_m ? SurfaceState::vague
                                                                       : SurfaceState::conflicts;
}

SurfaceMatch matched(const SurfaceCell& cell, const Pose& pose, const SurfaceIndex& other,
                     double tolerance_m) {
    SurfaceMatch match;
    match.place = pose * cell.mean;
    match.normal = pose.linear() * cell.normal;
    const SurfaceCell* across = nullptr;
    match.other = other.over(match.place, match.normal, kParallel, &across);
    if (!match.other) {
        match.other = across;
        match.state = match.other ? disagreement(cell, *match.other, tolerance_m) : SurfaceState::unseen;
        return match;
    }
    const Eigen::Vector3d offset = match.place - match.other->mean;
    match.distance_m = offset.dot(match.other->normal);
    match.predicted_m =
        std::sqrt(match.other->planeVariance(offset) + cell.thickness_m * cell.thickness_m / cell.count);
    match.state = std::abs(match.distance_m) <= tolerance_m ? SurfaceState::agrees
                                                            : disagreement(cell, *match.other, tolerance_m);
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
