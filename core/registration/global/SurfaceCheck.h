#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/registration/global/SurfaceLookup.h"

namespace vestige {

/// What the source's own points look like from its surfels: at an edge they lie off a surfel's plane, and so
/// will the target's.
struct SurfaceReference {
    std::vector<float> offset;  ///< mean signed distance to the plane
    std::vector<float> weight;  ///< by direction (directionWeights), less where the points lie on no plane
};

/// `points` of the source, metres, in the surfels' frame.
SurfaceReference surfaceReference(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source);

/// How well a pose lays source and target on each other, in detail: the target's own points against the
/// source's surfels. Many points to a surfel average the target's noise out, so poses can be told apart that
/// differ by less than it.
class SurfaceCheck {
  public:
    /// `points`: the target's, metres, in its search frame. `reference`: what each surfel's own points look
    /// like. All must outlive it.
    SurfaceCheck(std::span<const Eigen::Vector3f> points, const SurfaceLookup& source,
                 const SurfaceReference& reference);

    /// Point-to-plane Gauss-Newton (Chen, Medioni 1992): each surfel's plane to the mean of the target points
    /// within `tolerance_m` of it.
    Eigen::Isometry3d refined(const Eigen::Isometry3d& pose, double tolerance_m, int steps) const;

    /// Of each source surfel: mean signed distance of the target points within `reach_m` of its plane, less
    /// that of the source's own points; NaN where there are none.
    std::vector<float> offsets(const Eigen::Isometry3d& pose, double reach_m) const;

  private:
    std::span<const Eigen::Vector3f> points_;
    const SurfaceLookup& source_;
    const SurfaceReference& reference_;
};

/// What the offsets say of a pose: each surfel with target points near it speaks for or against.
struct Evidence {
    double coverage = 0;   ///< share of the source's surfels that have target points near them
    double agreement = 0;  ///< of these, -1 to 1, see evidenceOf

    /// At most 1. Coverage counts, but the less the more there is of it: a scan is made to show what the
    /// target does not.
    double score() const { return 1.25 * agreement * coverage / (coverage + 0.25); }
};

/// Mean over the surfels with target points of max(-1, 1 - (offset / (2 sigma))^2): the log likelihood ratio
/// of "this surface, normal with sigma" to "any surface near by", cut off and scaled.
Evidence evidenceOf(std::span<const float> offsets, std::span<const float> weights, double sigma_m);

/// Standard deviation of the offsets by their median; infinite for fewer than `least`.
double offsetScale(std::span<const float> offsets, std::size_t least);

/// How many are not NaN.
std::size_t knownOffsets(std::span<const float> offsets);

}  // namespace vestige
