#pragma once

#include "core/registration/RegistrationFrame.h"
#include "core/registration/quality/PoseInformation.h"
#include "core/registration/quality/SurfaceMatches.h"

namespace vestige {

/// Shares of surface (by area) of one cloud under a pose.
struct SurfaceShares {
    double agrees = 0;
    double conflicts = 0;
    double unseen = 0;
    /// Of all surface that could hold the pose in a direction the share that agrees, in the direction where
    /// it is least; a wrong pose on a street keeps its ground and loses what would hold it along the road.
    double support = 0;
    /// The same among the surface where the other cloud has some too.
    double seenSupport = 0;
};

/// Both clouds of a registration as planar cells: judges any pose between them, knowing nothing of how it was
/// found.
class SurfaceFit {
  public:
    /// `radius_m`: RMS distance of the source's surface from its middle; the cells' sizes come from it.
    SurfaceFit(const std::vector<Eigen::Vector3f>& target, const std::vector<Eigen::Vector3f>& source,
               double radius_m);

    /// Of the source's cells on the target's. `pose` maps the source's points to the target's.
    std::vector<SurfaceMatch> matches(const Pose& pose) const;
    SurfaceShares sourceShares(const Pose& pose) const;
    SurfaceShares targetShares(const Pose& pose) const;
    PoseInformation information(const Pose& pose) const;
    /// The pose that point-to-plane least squares finds next to this one, where the data hold it.
    Pose refined(const Pose& pose) const;
    /// The same quickly and from further away: some of the cells, which agree up to some times the tolerance
    /// first.
    Pose drawnIn(const Pose& pose) const;
    /// Share of the source's surface that agrees, by fewer cells still.
    double quickAgreement(const Pose& pose) const;

    double finest_m() const { return finest_m_; }  ///< edge of the smallest cells
    double tolerance_m() const { return tolerance_m_; }
    const SurfaceIndex& target() const { return target_; }
    const SurfaceIndex& source() const { return source_; }
    /// The middle of all surface of both clouds, in the target's frame.
    Eigen::Vector3d middle(const Pose& pose) const;

  private:
    Pose steppedTo(Pose pose, const std::vector<SurfaceCell>& cells, double tolerance_m, int steps) const;

    double finest_m_;
    SurfaceIndex target_;
    SurfaceIndex source_;
    double tolerance_m_;
    double cluster_m_;
    std::vector<SurfaceCell> some_;  // of the source's, evenly taken
    std::vector<SurfaceCell> few_;
};

/// x of (t, r w) about `pivot` that takes pose a to pose b, and back.
Vector6d stepBetween(const Pose& a, const Pose& b, const Eigen::Vector3d& pivot, double radius_m);
Pose stepped(const Pose& pose, const Vector6d& step, const Eigen::Vector3d& pivot, double radius_m);

}  // namespace vestige
