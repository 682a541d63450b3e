#include "core/io/LasWriter.h"

#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

PointCloud pair(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    PointCloudBuilder builder;
    builder.add(a);
    builder.add(b);
    return std::move(builder).build();
}

CrsRecord wkt(std::size_t size) {
    return {"LASF_Projection", 2112, "WKT", std::vector<std::uint8_t>(size, 'W'), false};
}

}  // namespace

TEST(LasWriter, PartsComeInOrderInTheWorldWithTheirSource) {
    const TemporaryFolder folder;
    const PointCloud aerial = fullCloud(20, true);
    const PointCloud scan = pair({1000, 2000, 3000}, {1500, 2500, 3500});
    Similarity worldFromScan;
    worldFromScan.scale = 0.001;
    worldFromScan.pose.translation() = Eigen::Vector3d(576661, 5188114, 150);
    for (const char* name : {"fused.las", "fused.laz"}) {
        LasWriteOptions options;
        options.creationDay = 33;
        options.creationYear = 2025;
        options.extraRecords = {{"Vestige", 1, "layers", {'a', 'b'}, false}};
        ASSERT_TRUE(writeLas(folder / name, {{&aerial, {}, 1}, {&scan, worldFromScan, 2}}, options));
        const LoadedGeometry back = readOrFail(folder / name);
        const PointCloud& cloud = back.geometry.vertices;
        ASSERT_EQ(cloud.size(), 22);
        EXPECT_LT((cloud.point(20) - Eigen::Vector3d(576662, 5188116, 153)).norm(), 1e-4);
        EXPECT_LT((cloud.point(0) - aerial.point(0)).norm(), 1e-4);
        EXPECT_EQ(cloud.attributes().pointSource[19], 1);
        EXPECT_EQ(cloud.attributes().pointSource[20], 2);
        EXPECT_EQ(cloud.attributes().color[20], (Color{0, 0, 0}));
        EXPECT_EQ(back.info.creationDayYear, std::pair(33, 2025));
        EXPECT_EQ(back.info.version, "1.4, point format 7");
        EXPECT_TRUE(back.info.warnings.empty());
    }
}

TEST(LasWriter, CoarsensTheScaleOnlyWhereTheExtentDemandsIt) {
    const TemporaryFolder folder;
    const auto scaleOf = [&](const PointCloud& cloud, const LasWriteOptions& options) {
        EXPECT_TRUE(writeLas(folder / "a.las", {{&cloud, {}, 0}}, options));
        const LoadedGeometry back = readOrFail(folder / "a.las");
        EXPECT_LE(largestDifference(cloud, back.geometry.vertices), 0.51 * back.info.scale->x() + 2e-5);
        return *back.info.scale;
    };
    EXPECT_EQ(scaleOf(pair({5e5, 5e6, 0}, {5e5 + 1000, 5e6, 100}), {}), Eigen::Vector3d::Constant(1e-4));
    EXPECT_NEAR(scaleOf(pair({-4e6, 0, 0}, {4e6, 1, 1}), {}).x(), 0.01, 1e-12);
    LasWriteOptions source;
    source.scale = Eigen::Vector3d::Constant(0.001);
    source.offset = Eigen::Vector3d::Zero();
    // At 5 000 km the source's offset of 0 does not fit into 32 bits of a millimetre; another one does.
    EXPECT_EQ(scaleOf(pair({5e5, 5e6, 0}, {5e5 + 1000, 5e6 + 1, 100}), source),
              Eigen::Vector3d::Constant(0.001));
}

TEST(LasWriter, CarriesTheReferenceSystemOnInRecordsOfBothKinds) {
    const TemporaryFolder folder;
    const PointCloud cloud = fullCloud(3, true);
    for (const char* name : {"a.las", "a.laz"}) {
        for (const std::size_t size : {std::size_t{200}, std::size_t{70000}}) {
            LasWriteOptions options;
            options.crsRecords = {wkt(size)};
            ASSERT_TRUE(writeLas(folder / name, {{&cloud, {}, 0}}, options));
            const LoadedGeometry back = readOrFail(folder / name);
            ASSERT_EQ(back.info.crsRecords.size(), 1);
            EXPECT_EQ(back.info.crsRecords[0].bytes, options.crsRecords[0].bytes);
            EXPECT_EQ(back.info.crsRecords[0].extended, size > 65535);
            EXPECT_EQ(back.info.crs, std::string(size, 'W'));
            ASSERT_TRUE(writeGeometry(folder / "again.las", back.geometry, {&back.info}));
            EXPECT_EQ(readOrFail(folder / "again.las").info.crs, back.info.crs);
        }
    }
}

TEST(FileInfo, TellsWhatReadingTells) {
    const TemporaryFolder folder;
    const PointCloud cloud = fullCloud(500, false);
    for (const char* name : {"a.las", "a.laz", "a.ply"}) {
        ASSERT_TRUE(writeGeometry(folder / name, {cloud, {}}));
        const Result<FileInfo> info = fileInfo(folder / name);
        ASSERT_TRUE(info) << info.error().sentence();
        const FileInfo read = readOrFail(folder / name).info;
        EXPECT_EQ(info->points, 500);
        EXPECT_EQ(info->attributes, read.attributes);
        EXPECT_EQ(info->timeSpan, read.timeSpan);
        EXPECT_LT((info->bounds.min - read.bounds.min).norm() + (info->bounds.max - read.bounds.max).norm(),
                  1e-4);
        EXPECT_EQ(info->sha256.size(), 64);
    }
}
