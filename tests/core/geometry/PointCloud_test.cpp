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

TEST(PointCloud, ACloudThatIsGivenAwayIsMovedInPlaceAndIsTheSame) {
    Similarity move;
    move.pose =
        Eigen::Translation3d(4e5, -3, 12) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    for (const double scale : {0.001, 0.3048, 1.0, 40.0}) {
        for (const double extent : {10.0, 200.0, 300.0, 9000.0}) {
            move.scale = scale;
            Random random(3);
            PointCloudBuilder builder;
            for (int i = 0; i < 500; ++i) {
                builder.add({1e6 + random.uniform(0, extent), random.uniform(0, extent), 0.3 * i});
                builder.attributes().color.push_back({1, 2, static_cast<std::uint16_t>(i)});
                builder.attributes().normal.push_back(Eigen::Vector3f::UnitX());
            }
            PointCloud cloud = std::move(builder).build();
            // By the builder, which says what a cloud holds.
            PointCloudBuilder anew(move * cloud.origin());
            anew.resize(cloud.size());
            for (std::size_t i = 0; i < cloud.size(); ++i) anew.setPoint(i, move * cloud.point(i));
            const PointCloud truth = std::move(anew).build();
            const PointCloud copied = cloud.transformed(move);
            const auto* colors = cloud.attributes().color.data();
            const auto* offsets = cloud.offsets().data();
            const PointCloud moved = std::move(cloud).transformed(move);
            EXPECT_EQ(moved.attributes().color.data(), colors) << "copied";
            EXPECT_EQ(moved.offsets().data(), offsets) << "copied";
            for (const PointCloud* one : {&copied, &moved}) {
                EXPECT_EQ(one->origin(), truth.origin());
                EXPECT_EQ(one->offsets(), truth.offsets());
                EXPECT_EQ(one->residuals(), truth.residuals()) << scale << ' ' << extent;
                EXPECT_EQ(one->bounds().min, truth.bounds().min);
                EXPECT_EQ(one->bounds().max, truth.bounds().max);
                EXPECT_EQ(one->attributes().color, copied.attributes().color);
                EXPECT_EQ(one->attributes().normal[7],
                          move.pose.linear().cast<float>() * Eigen::Vector3f::UnitX());
            }
        }
    }
}

TEST(PointCloud, AGridStaysBehindWhenItsPointsAreMoved) {
    const CoordinateGrid grid{Eigen::Vector3d::Constant(0.01), Eigen::Vector3d::Zero()};
    LargeArray<Eigen::Vector3f> offsets;
    for (int i = 0; i < 100; ++i) offsets.push_back(0.01F * Eigen::Vector3f(static_cast<float>(i), 7, 3));
    BoundingBox bounds;
    bounds.add(Eigen::Vector3d(0, 0.07, 0.03));
    bounds.add(Eigen::Vector3d(0.99, 0.07, 0.03));
    PointCloud cloud(Eigen::Vector3d::Zero(), std::move(offsets), grid, bounds, {});
    ASSERT_TRUE(cloud.grid());
    const PointCloud feet = std::move(cloud).transformed({Pose::Identity(), 0.3048});
    EXPECT_FALSE(feet.grid());
    for (int i = 0; i < 100; ++i)
        EXPECT_NEAR(feet.point(static_cast<std::size_t>(i)).x(), 0.01 * i * 0.3048, 1e-7);
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
