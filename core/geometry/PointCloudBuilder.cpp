#include "core/geometry/PointCloudBuilder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vestige {

void PointCloudBuilder::reserve(std::size_t count) {
    offsets_.reserve(count);
}

void PointCloudBuilder::add(const Eigen::Vector3d& world) {
    if (!origin_) origin_ = world.array().round().matrix();
    const Eigen::Vector3d offset = world - *origin_;
    const Eigen::Vector3f rounded = offset.cast<float>();
    offsets_.push_back(rounded);
    // Residuals begin with the first far point; everything before it was near and has none.
    if (!residuals_.empty() || rounded.cwiseAbs().maxCoeff() > kExactRange) {
        residuals_.resize(offsets_.size() - 1, Eigen::Vector3f::Zero());
        residuals_.push_back((offset - rounded.cast<double>()).cast<float>());
    }
}

void PointCloudBuilder::resize(std::size_t count) {
    assert(origin_);
    offsets_.resize(count, Eigen::Vector3f::Zero());
    residuals_.resize(count, Eigen::Vector3f::Zero());
}

void PointCloudBuilder::setPoint(std::size_t i, const Eigen::Vector3d& world) {
    const Eigen::Vector3d offset = world - *origin_;
    offsets_[i] = offset.cast<float>();
    residuals_[i] = (offset - offsets_[i].cast<double>()).cast<float>();
}

PointCloud PointCloudBuilder::build() && {
    const bool far = std::any_of(offsets_.begin(), offsets_.end(), [](const Eigen::Vector3f& offset) {
        return offset.cwiseAbs().maxCoeff() > kExactRange;
    });
    if (!far) residuals_ = {};
    return {origin_.value_or(Eigen::Vector3d::Zero()), std::move(offsets_), std::move(residuals_),
            std::move(attributes_)};
}

}  // namespace vestige
