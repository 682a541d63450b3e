#pragma once

#include <vector>

#include "core/registration/RegistrationFrame.h"
#include "core/registration/ndt/MomentPyramid.h"

namespace vestige {

/// The source's points at any thinning, gathered once: one centroid per voxel, neighbours in space near in
/// memory.
class SourceLevels {
  public:
    /// `frame` must outlive the levels; `leaf` is the finest thinning, metres. It doubles, up to `largest`,
    /// until its voxels hold four points on average: the mean of fewer is hardly better than one of them.
    SourceLevels(const RegistrationFrame& frame, double leaf, double largest = 0);

    /// Thinned to `size`, or to the leaf where that is larger.
    CentredSource at(double size) const;

  private:
    const RegistrationFrame& frame_;
    double leaf_;
    MomentPyramid stages_;
};

}  // namespace vestige
