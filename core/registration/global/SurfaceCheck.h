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
    /// Two surfels side by side on the same surface.
    struct Neighbours {
        std::uint32_t one;
        std::uint32_t other;
        float sign;  ///< -1 where their normals point to opposite sides
    };
    std::vector<Neighbours> neighbours;
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
    /// that of the source's own points, and how many they are.
    struct Offsets {
        std::vector<float> mean;  ///< meaningless where there are no points
        std::vector<std::uint32_t> points;
    };
    Offsets offsets(const Eigen::Isometry3d& pose, double reach_m) const;

  private:
    std::span<const Eigen::Vector3f> points_;
    const SurfaceLookup& source_;
    const SurfaceReference& reference_;
};

/// What the offsets say of a pose: how alike the surfaces are in shape, and how near they lie.
struct Evidence {
    double coverage = 0;  ///< weighted share of the source's surfels that have target points near them
    /// Of these, -1 to 1: the mean of max(-1, 1 - (offset / (2 sigma))^2), the log likelihood ratio of "this
    /// surface, normal with sigma" to "any surface near by", cut off and scaled.
    double agreement = 0;
    /// Mean square by which the two surfaces differ in shape, and the standard error of that figure, m^2.
    /// Noise does not add to it, so it may come out below zero.
    double mismatch_m2 = 0;
    double mismatchError_m2 = 0;

    /// What the mismatch may well be, m^2.
    double mostMismatch_m2() const;
};

/// Coverage and agreement of offsets whose spread is `sigma_m`. Neighbours on a surface share an error of
/// shape, but not the target's noise: the mismatch is the mean product of the offsets of neighbouring
/// surfels.
Evidence evidenceOf(const SurfaceCheck::Offsets& offsets, const SurfaceReference& reference, double sigma_m);

/// Standard deviation of the offsets by their median; infinite for fewer than `least`.
double offsetScale(const SurfaceCheck::Offsets& offsets, std::size_t least);

/// How many surfels have target points.
std::size_t knownOffsets(const SurfaceCheck::Offsets& offsets);

}  // namespace vestige
