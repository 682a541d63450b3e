#pragma once

#include <Eigen/Geometry>

#include "core/geometry/PoseUncertainty.h"

namespace vestige {

/// A small motion, and its length: shift and turn of the points that asked for it, metres.
struct SmallTurn {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    double size = 0;
};

/// The normal equations of point-to-plane distances (Chen, Medioni 1992).
class PlaneEquations {
  public:
    /// A point that has to move by -`distance` along `normal`.
    void add(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, double distance, double weight);

    /// The motion that brings the weighted distances to least squares; directions that nothing holds do not
    /// move. Nothing moves where there is nothing to solve.
    SmallTurn solve() const;

  private:
    Matrix6d squares_ = Matrix6d::Zero();
    Vector6d products_ = Vector6d::Zero();
    double weight_ = 0;
    Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
    double norms_ = 0;
};

}  // namespace vestige
