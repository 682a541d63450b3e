#pragma once

#include <span>
#include <vector>

#include "core/registration/global/ProposePoses.h"
#include "core/registration/global/SurfaceCheck.h"

namespace vestige {

struct JudgedPose {
    Eigen::Isometry3d targetFromSource = Eigen::Isometry3d::Identity();
    Evidence evidence;
};

/// The proposals refined on the target's own points and judged by them, best first, each place once. The
/// spread that the best of them shows is the standard deviation that all are held against. `target` are
/// metres from the target's search origin.
std::vector<JudgedPose> judgePoses(std::span<const Eigen::Vector3f> target, const Surfels& source,
                                   std::span<const Eigen::Vector3f> points,
                                   std::span<const ProposedPose> proposals);

/// Whether the data leave room for `other` beside `best`: it agrees as well but for `margin`, a share, with
/// no much smaller part of the source.
bool rivals(const JudgedPose& other, const JudgedPose& best, double margin);

}  // namespace vestige
