#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/geometry/Pose.h"

namespace vestige {

/// The points as PCL's cloud type `Cloud`.
template <class Cloud>
std::shared_ptr<Cloud> cloudOf(const std::vector<Eigen::Vector3f>& points) {
    auto cloud = std::make_shared<Cloud>();
    cloud->reserve(points.size());
    for (const Eigen::Vector3f& point : points) cloud->emplace_back(point.x(), point.y(), point.z());
    return cloud;
}

/// PCL's float matrix as a pose whose rotation is orthonormal again.
inline Pose poseOf(const Eigen::Matrix4f& matrix) {
    Pose pose = Pose::Identity();
    pose.linear() = nearestRotation(matrix.topLeftCorner<3, 3>().cast<double>());
    pose.translation() = matrix.topRightCorner<3, 1>().cast<double>();
    return pose;
}

}  // namespace vestige
