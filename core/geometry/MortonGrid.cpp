#include "core/geometry/MortonGrid.h"

#include <algorithm>

namespace vestige {
namespace {

constexpr double kSteps = 1 << MortonGrid::kLevels;

/// Two zero bits before each of the lowest 21 bits (the masks of Stocco and Schrack 1995).
std::uint64_t spread(std::uint64_t value) {
    value = (value | value << 32) & 0x001f00000000ffffULL;
    value = (value | value << 16) & 0x001f0000ff0000ffULL;
    value = (value | value << 8) & 0x100f00f00f00f00fULL;
    value = (value | value << 4) & 0x10c30c30c30c30c3ULL;
    return (value | value << 2) & 0x1249249249249249ULL;
}

}  // namespace

MortonGrid::MortonGrid(std::span<const Eigen::Vector3f> offsets) {
    Eigen::Vector3f least = offsets.front();
    Eigen::Vector3f most = offsets.front();
    for (const Eigen::Vector3f& offset : offsets) {
        least = least.cwiseMin(offset);
        most = most.cwiseMax(offset);
    }
    least_ = least.cast<double>();
    side_ = (most.cast<double>() - least_).maxCoeff();
    stepsPerUnit_ = side_ > 0 ? kSteps / side_ : 0;
}

std::uint64_t MortonGrid::code(const Eigen::Vector3f& offset) const {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double steps = (static_cast<double>(offset[axis]) - least_[axis]) * stepsPerUnit_;
        code |= spread(static_cast<std::uint64_t>(std::clamp(steps, 0.0, kSteps - 1))) << (2 - axis);
    }
    return code;
}

}  // namespace vestige
