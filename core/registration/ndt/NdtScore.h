#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/geometry/PoseUncertainty.h"
#include "core/registration/ndt/NdtKernel.h"

namespace vestige {

/// A scored pose: S, its gradient and its Hessian by p = (t, r w), all in metres (METHOD section 3, steps 3
/// and 4).
struct ScoredPose {
    double score = 0;
    Vector6d gradient = Vector6d::Zero();
    Matrix6d hessian = Matrix6d::Zero();
    std::size_t inside = 0;  ///< source points that lie in a cell
};

/// Source points round their centroid, and the scale that turns radians into metres.
struct CentredSource {
    std::vector<Eigen::Vector3f> points;               ///< metres, round the centroid
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< the centroid in the source's file, in metres
    double radius = 0;                                 ///< RMS distance from the centroid
};

/// The score of METHOD section 3, step 3: S = mean over all source points of d1 exp(-d2 q / 2), a point in no
/// cell adding nothing. Lower is better. The same bits for any thread count.
class NdtScore {
  public:
    /// `target` is one voxel size, or several from large to small: a point counts in the smallest cell that
    /// holds it (docs/decisions/0004-registration-beyond-the-publication.md). `shifted` are further grids of
    /// the smallest size, each of which takes its place in turn: the score is the mean over all of them. The
    /// distributions must outlive the score.
    NdtScore(std::span<const NormalDistributions> target, const CentredSource& source,
             std::span<const NormalDistributions> shifted = {});

    /// Of the poses of one descent; spares those that follow each other closely most of the search for cells.
    using Memory = std::vector<FoundCells>;
    /// `pose` maps the centred source into the target's cells. One memory must not be used by two threads.
    ScoredPose operator()(const Pose& pose, Memory* memory = nullptr) const;
    /// S alone.
    double value(const Pose& pose) const;

    /// The pose after a step p: R turned by w = p[3..5] / radius (to third order), t + dt.
    static Pose moved(const Pose& pose, const Vector6d& step, double radius);

  private:
    using Levels = std::vector<const NormalDistributions*>;  // from small to large

    std::vector<Levels> grids_;
    PointLanes source_;
    double radius_;
};

}  // namespace vestige
