#pragma once

#include <Eigen/Core>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// A cloud's points in metres with z up, as floats round a place of its own: what ground and objects are
/// found in. `upFromCloud` leads into a frame whose z axis is up (the scene). The cloud must outlive it.
class UprightPoints {
  public:
    UprightPoints(const PointCloud& cloud, const Similarity& upFromCloud)
        : offsets_(cloud.offsets()),
          place_(cloud.empty() ? Eigen::Vector3d::Zero() : (upFromCloud * cloud.bounds().centre()).eval()),
          turn_((upFromCloud.pose.linear() * upFromCloud.scale).cast<float>()),
          shift_((upFromCloud * cloud.origin() - place_).cast<float>()) {}

    std::size_t size() const { return offsets_.size(); }
    Eigen::Vector3f operator[](std::size_t i) const { return turn_ * offsets_[i] + shift_; }
    /// Where the floats' origin lies in the upright frame.
    const Eigen::Vector3d& place() const { return place_; }

  private:
    const LargeArray<Eigen::Vector3f>& offsets_;
    Eigen::Vector3d place_;
    Eigen::Matrix3f turn_;
    Eigen::Vector3f shift_;
};

}  // namespace vestige
