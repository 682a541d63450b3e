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
    double voxelStart_m = 4;        ///< v0
    std::optional<double> voxel_m;  ///< v_n; nothing: chosen by flatness
    double voxelFloor_m = 0.1;      ///< the smallest v_n that is considered
    /// The largest v_n that is chosen where smaller cells hold enough points: cells must resolve the source.
    double voxelCeiling_m = 100;
    std::optional<double> leaf_m;  ///< thinning of the source; nothing: v_n / 2
    /// Where a level has no cell the next larger one counts, so that far surfaces keep their hold.
    bool coarserCells = true;
    /// Grids, shifted against each other, whose mean score the last level takes: where the faces of one grid
    /// lie would move the pose by a centimetre.
    int shiftedGrids = 4;
    /// Takes DistributionOptions::rangeNoise_m from the target itself, at v0.
    bool estimateNoise = false;
    DistributionOptions distributions;
    TrustRegionOptions trustRegion;
};

/// METHOD section 3 from `initial`, one pose per voxel size, each starting from the one before.
/// ErrorCode::untrustworthy when no source point falls into a target cell or either cloud is too small.
Result<RegistrationResult> improvedNdt(const RegistrationFrame& frame, const Similarity& initial,
                                       const ImprovedNdtOptions& options, const JobControl& control,
                                       const RegistrationWatch& watch = {});

}  // namespace vestige
