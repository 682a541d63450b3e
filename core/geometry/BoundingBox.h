#pragma once

#include <Eigen/Core>
#include <limits>

#include "core/geometry/Pose.h"

namespace vestige {

/// Axis-parallel box in world coordinates (double); empty until something is added.
struct BoundingBox {
    Eigen::Vector3d min = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d max = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

    bool empty() const { return !(min.array() <= max.array()).all(); }
    void add(const Eigen::Vector3d& point);
    void add(const BoundingBox& other);
    /// Its faces belong to it.
    bool contains(const Eigen::Vector3d& point) const {
        return (point.array() >= min.array()).all() && (point.array() <= max.array()).all();
    }
    Eigen::Vector3d centre() const { return 0.5 * (min + max); }
    Eigen::Vector3d extent() const { return empty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(max - min); }
    double diagonal() const { return extent().norm(); }
    /// The box round this box's eight corners after the motion.
    BoundingBox transformed(const Similarity& toFromHere) const;
};

}  // namespace vestige
