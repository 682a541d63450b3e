#pragma once

#include <vector>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/geometry/Pose.h"

namespace vestige::test {

inline Pose pose(double x, double y, double yaw) {
    Pose made = Pose::Identity();
    made.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    made.translation() << x, y, 0;
    return made;
}

/// A room of 6 x 4 x 2.5 m with a box in it, as seen from `worldFromScanner` (no occlusion).
inline PointCloud room(const Pose& worldFromScanner, std::uint64_t seed) {
    Random random(seed);
    PointCloudBuilder builder;
    const auto sides = [&](const Eigen::Vector3d& min, const Eigen::Vector3d& size, int count) {
        for (int i = 0; i < count; ++i) {
            Eigen::Vector3d at{random.uniform(), random.uniform(), random.uniform()};
            at[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 0 : 1;
            const Eigen::Vector3d noise{random.normal(0, 0.003), random.normal(0, 0.003),
                                        random.normal(0, 0.003)};
            builder.add(worldFromScanner.inverse() * (min + at.cwiseProduct(size) + noise));
        }
    };
    sides({-3, -2, 0}, {6, 4, 2.5}, 20000);
    sides({0.5, 0.4, 0}, {0.8, 0.5, 1.1}, 3000);
    return std::move(builder).build();
}

inline std::vector<Pose> walk() {
    return {pose(0, 0, 0), pose(0.15, 0.05, 0.05), pose(0.3, 0.02, 0.12), pose(0.4, -0.1, 0.1)};
}

}  // namespace vestige::test
