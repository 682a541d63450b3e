#pragma once

#include <span>
#include <vector>

#include "core/registration/global/ProposePoses.h"
#include "core/registration/global/SurfaceCheck.h"

namespace vestige {

struct JudgedPose {
    Eigen::Isometry3d targetFromSource = Eigen::Isometry3d::Identity();
    Evidence evidence;
    double score = 0;  ///< at most 1
};

/// By what poses are told apart. A local scan, a small part of the target, is made to show what the target
/// does not: how much of it the target shows says little, and things of nearly the same shape stand about,
/// so it is judged by shape. A whole scan is judged by how much of it lies where the target does.
enum class JudgeBy { shape, cover };

/// The proposals refined on the target's own points and judged by them, best first, each place once. `target`
/// are metres from the target's search origin, `points` the source's own from its.
std::vector<JudgedPose> judgePoses(std::span<const Eigen::Vector3f> target, const Surfels& source,
                                   std::span<const Eigen::Vector3f> points,
                                   std::span<const ProposedPose> proposals, JudgeBy by);

/// Whether the data leave room for `other` beside `best`. By shape: it is shown to differ in shape by little
/// more than the best, on no very much smaller part of the source. By cover: it agrees as well but for
/// `margin`, a share, on a part nearly as large.
bool rivals(const JudgedPose& other, const JudgedPose& best, JudgeBy by, double voxel_m, double margin);

}  // namespace vestige
