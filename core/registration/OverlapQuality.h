#pragma once

#include <span>
#include <vector>

#include "core/registration/RegistrationResult.h"
#include "core/registration/ndt/NdtScore.h"

namespace vestige {

/// Distance of each source point to the target's surface, metres: across the smallest cell that holds it (its
/// plane, where it is flat). Infinite where no cell does. `surfaces` runs from large to small; `pose` maps
/// the centred source into the target's frame.
std::vector<float> surfaceDistances(std::span<const NormalDistributions> surfaces,
                                    const CentredSource& source, const Pose& pose);

/// The standard deviation of finite distances as their median tells it; 0 when there is none.
double typicalDistance(std::vector<float> distances);

/// Sets overlap, targetOverlap and rmse_m: a source point is an inlier when its distance is at most
/// `inlierDistance_m`; the target's share counts its cells of twice the smallest size that hold an inlier.
void setOverlap(RegistrationResult& result, std::span<const NormalDistributions> surfaces,
                const CentredSource& source, const Pose& pose);

}  // namespace vestige
