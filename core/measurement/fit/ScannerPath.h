#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// Where a moving scanner was, found from its cloud: echoes of one pulse lie on one beam, and the beams of
/// half a second meet where the scanner was. (Gatziolis and McGaughey 2019 find aircraft trajectories so.)
/// Cloud's frame and unit.
class ScannerPath {
  public:
    /// Nothing for a cloud without times and numbers of returns, with too few pulses of several echoes, or
    /// whose beams do not meet.
    static std::optional<ScannerPath> recovered(const PointCloud& cloud);

    /// Where the scanner was when it measured the point `index` of that cloud, with the time of its pulse.
    /// Nothing at times when too few beams were found.
    std::optional<Eigen::Vector3d> at(double time_s) const;
    double timeOf(std::size_t index) const { return times_[index]; }
    std::size_t size() const { return times_.size(); }

  private:
    /// Position and velocity about the middle of a piece of time.
    struct Piece {
        bool known = false;
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
        Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    };
    std::vector<Piece> pieces_;
    double start_s_ = 0;
    std::vector<double> times_;
};

}  // namespace vestige
