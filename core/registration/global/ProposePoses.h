#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/registration/global/Surfels.h"

namespace vestige {

/// A pose between two search frames and how well the surfels lie on each other there, 0 to 1.
struct ProposedPose {
    Eigen::Isometry3d targetFromSource = Eigen::Isometry3d::Identity();
    double score = 0;
};

/// At most `count` distinct poses that lay the source's surfels on the target's, best first: features of
/// both, the matches that agree with each other, each proposal refined on the target's surfels. Bit-identical
/// for any thread count. Throws ErrorException when cancelled.
std::vector<ProposedPose> proposePoses(const Surfels& target, const Surfels& source, std::size_t count,
                                       const JobControl& control);

/// Sorts best first and drops poses that put the source within `shift_m` and 10 degrees of a better one.
void keepDistinct(std::vector<ProposedPose>& poses, double shift_m);

/// Whether the two put the source's middle within `shift_m` and turn it alike to 10 degrees.
bool samePlace(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double shift_m);

}  // namespace vestige
