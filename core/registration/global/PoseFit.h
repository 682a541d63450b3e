#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/registration/global/SurfaceLookup.h"

namespace vestige {

/// How well a pose lays source surfels on the target's surface.
class PoseFit {
  public:
    /// `weights` as many as source surfels, or empty for equal ones. Both must outlive it.
    PoseFit(const Surfels& source, std::vector<float> weights);

    /// Weighted share, 0 to 1, of the source that lies on the target: 1 - (distance to the target's local
    /// plane / tolerance)^2 of each surfel where that is positive and the normals agree to 45 degrees.
    double score(const SurfaceLookup& target, const Eigen::Isometry3d& pose, double tolerance_m) const;

    /// The pose after some Gauss-Newton steps of point-to-plane distances (Chen, Medioni 1992) to the surfels
    /// that lie within the tolerance.
    Eigen::Isometry3d refined(const SurfaceLookup& target, Eigen::Isometry3d pose, double tolerance_m,
                              int steps) const;

    std::size_t size() const { return source_.size(); }

  private:
    const Surfels& source_;
    std::vector<float> weights_;
    double total_ = 0;
};

/// Weights that let every direction of a surface count: those of a direction that many surfels share (the
/// ground) are divided by the square root of their number.
std::vector<float> directionWeights(const Surfels& surfels);

}  // namespace vestige
