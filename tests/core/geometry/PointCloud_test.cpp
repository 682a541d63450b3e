#include "core/geometry/PointCloud.h"

#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/geometry/TriangleMesh.h"

using namespace vestige;

TEST(PointCloud, KeepsWorldCoordinatesAtAnyMagnitudeAndExtent) {
    for (const double magnitude : {0.0, 5e5, 4.4e6, 1e9}) {
        for (const double extent : {1.0, 300.0, 20000.0}) {
            Random random(1);
            PointCloudBuilder builder;
            std::vector<Eigen::Vector3d> truth;
            for (int i = 0; i < 1000; ++i) {
                truth.emplace_back(magnitude + random.uniform(0, extent),
                                   -magnitude + random.uniform(0, extent), random.uniform(0, extent));
                builder.add(truth.back());
            }
            const PointCloud cloud = std::move(builder).build();
            for (std::size_t i = 0; i < truth.size(); ++i)
                ASSERT_LT((cloud.point(i) - truth[i]).cwiseAbs().maxCoeff(), 2e-5 + 1e-15 * magnitude)
                    << magnitude << ' ' << extent;
        }
    }
}

TEST(PointCloud, TransformedThereAndBackIsTheSame) {
    PointCloudBuilder builder;
    builder.add({483400.57912345, 4375661.7064321, 34.825});
    builder.add({483410.1, 4375699.9, 30.25});
    builder.attributes().normal = {Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitZ()};
    const PointCloud cloud = std::move(builder).build();
    Similarity move;
    move.scale = 1000;
    move.pose =
        Eigen::Translation3d(-4e8, 3, 12) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    const PointCloud back = cloud.transformed(move).transformed(move.inverse());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        EXPECT_LT((back.point(i) - cloud.point(i)).norm(), 2e-5);
        EXPECT_LT((back.attributes().normal[i] - cloud.attributes().normal[i]).norm(), 1e-6F);
    }
}

TEST(TriangleMesh, SamplingKeepsDensityAndLiesOnTheSurface) {
    PointCloudBuilder builder;
    for (const auto& corner : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(2, 0, 1), Eigen::Vector3d(2, 3, 1),
                               Eigen::Vector3d(0, 3, 1)})
        builder.add(corner);
    const TriangleMesh mesh{std::move(builder).build(), {{0, 1, 2}, {0, 2, 3}}};
    EXPECT_DOUBLE_EQ(surfaceArea(mesh), 6);
    const PointCloud sampled = sampleSurface(mesh, 0.05);
    EXPECT_NEAR(static_cast<double>(sampled.size()), 6 / (0.05 * 0.05), 2);
    EXPECT_NEAR(sampled.bounds().max.x(), 2, 0.05);
    EXPECT_EQ(sampled.bounds().min.z(), 1);
    EXPECT_EQ(sampled.attributes().normal.size(), sampled.size());
}
