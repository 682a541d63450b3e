#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/registration/ndt/NdtScore.h"

namespace vestige {

/// The frame that a registration computes in: metres, float offsets round the middle of the target's part
/// that the source can reach. Moving either cloud's world coordinates moves the frame along, so the result
/// does not depend on how large they are.
class RegistrationFrame {
  public:
    /// Keeps the target's points within `margin_m` of the source's bounds under `initial`.
    RegistrationFrame(const PointCloud& target, const PointCloud& source, const Similarity& initial,
                      double margin_m);

    const std::vector<Eigen::Vector3f>& target() const { return target_; }
    /// The source's points, metres.
    const std::vector<Eigen::Vector3f>& source() const { return source_; }
    /// The largest coordinate of either.
    double extent_m() const;
    /// These points of the source round their centroid.
    CentredSource centred(std::vector<Eigen::Vector3f> points) const;

    /// Between a pose of the two files' metres and one of the centred source and the target's offsets.
    Pose toLocal(const Pose& targetFromSource, const CentredSource& source) const;
    Pose toWorld(const Pose& localFromCentred, const CentredSource& source) const;

  private:
    Eigen::Vector3d targetOrigin_;
    Eigen::Vector3d sourceOrigin_;
    std::vector<Eigen::Vector3f> target_;
    std::vector<Eigen::Vector3f> source_;  // round sourceOrigin_
};

/// RMS distance of a cloud's surface from its centre, in its own unit: every stretch of surface counts the
/// same, however densely it was scanned.
double surfaceRadius(const PointCloud& cloud);

}  // namespace vestige
