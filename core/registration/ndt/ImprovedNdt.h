#pragma once

#include <optional>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/registration/RegistrationFrame.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"
#include "core/registration/ndt/NormalDistributions.h"
#include "core/registration/ndt/TrustRegion.h"

namespace vestige {

struct ImprovedNdtOptions {
    /// The scheme of the publication: all sizes of the schedule down to v_n, classic cells, no last stage on
    /// surfaces. Else docs/decisions/0007-ndt-kernel-and-schedule.md.
    bool published = false;
    double voxelStart_m = 4;        ///< v0
    std::optional<double> voxel_m;  ///< v_n; nothing: chosen by flatness
    double voxelFloor_m = 0.25;     ///< the smallest v_n that is considered
    /// The largest v_n that is chosen where smaller cells hold enough points: cells must resolve the source.
    double voxelCeiling_m = 100;
    std::optional<double> leaf_m;  ///< thinning of the source; nothing: v_n (published: v_n / 2)
    /// Grids, shifted against each other, whose mean score the last stage takes: where the faces of one grid
    /// lie would move a small source by a centimetre.
    int shiftedGrids = 1;
    /// Tries a fan of other starts where the first pose leads to one that explains too little of the source.
    bool startFan = false;
    /// Takes DistributionOptions::rangeNoise_m from the target itself, at v0.
    bool estimateNoise = false;
    DistributionOptions distributions;
    std::optional<double> trustRadius_m;  ///< first bound of a step; nothing: a quarter of the voxel
    TrustRegionOptions trustRegion;
};

/// METHOD section 3 from `initial`, one pose per voxel size, each starting from the one before.
/// ErrorCode::untrustworthy when either cloud is too small. Where no source point falls into a target cell
/// the level, and the result, say so (StopReason::noOverlap).
Result<RegistrationResult> improvedNdt(const RegistrationFrame& frame, const Similarity& initial,
                                       const ImprovedNdtOptions& options, const JobControl& control,
                                       const RegistrationWatch& watch = {});

}  // namespace vestige
