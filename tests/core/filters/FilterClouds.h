#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige::test {

/// `world` rounded to 1/1024, which every origin and offset holds exactly.
inline Eigen::Vector3d dyadic(const Eigen::Vector3d& world) {
    return (world * 1024).array().round() / 1024;
}

inline PointCloud cloudOf(const std::vector<Eigen::Vector3d>& points,
                          const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
    PointCloudBuilder builder(origin);
    for (const Eigen::Vector3d& point : points) builder.add(point);
    return std::move(builder).build();
}

/// A rough surface with trees over it, round `middle`; about 5 cm between points.
inline std::vector<Eigen::Vector3d> roughScene(std::size_t count, const Eigen::Vector3d& middle) {
    Random random(17);
    const double side = 0.05 * std::sqrt(static_cast<double>(count));
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(-0.5, 0.5) * side;
        const double y = random.uniform(-0.5, 0.5) * side;
        const double z = i % 8 == 0 ? random.uniform(0, 2) : 0.3 * std::sin(x) + 0.01 * random.normal();
        points.push_back(dyadic(middle + Eigen::Vector3d(x, y, z)));
    }
    return points;
}

/// Same points, attributes and residuals, bit for bit.
inline void expectIdentical(const PointCloud& a, const PointCloud& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a.point(i), b.point(i)) << i;
    EXPECT_EQ(a.attributes().intensity, b.attributes().intensity);
    EXPECT_EQ(a.attributes().color, b.attributes().color);
    EXPECT_EQ(a.attributes().classification, b.attributes().classification);
    EXPECT_EQ(a.attributes().gpsTime, b.attributes().gpsTime);
}

}  // namespace vestige::test
