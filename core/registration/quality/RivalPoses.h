#pragma once

#include <vector>

#include "core/registration/quality/SurfaceFit.h"

namespace vestige {

/// A pose elsewhere under which the surfaces look much alike, and how well.
struct RivalPose {
    Pose pose;
    double score = 0;  ///< poseScore of it
};

/// How well a pose explains both clouds: to compare poses of one pair. 0 to 4.
double poseScore(const SurfaceShares& source, const SurfaceShares& target);
double poseScore(const SurfaceFit& fit, const Pose& pose);

/// Poses to hold against the found one: the source turned about the vertical (z) by nothing, a half and the
/// quarters, and slid to where its walls fall on the target's (the heaviest agreements of the walls' places
/// along the two directions that most walls face). The best few by the surface that agrees, refined, the best
/// first; those that lead back to the found pose are left out. Rooms and rows of columns look alike from
/// behind, fronts of houses one window further.
std::vector<RivalPose> rivalPoses(const SurfaceFit& fit, const Pose& found, double apart_m);

}  // namespace vestige
