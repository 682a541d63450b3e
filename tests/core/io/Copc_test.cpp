#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "core/io/ApplyReadOptions.h"
#include "core/io/Bytes.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

using Place = std::tuple<double, double, double, float>;

std::vector<Place> places(const PointCloud& cloud) {
    std::vector<Place> all;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d point = cloud.point(i);
        all.emplace_back(point.x(), point.y(), point.z(), cloud.attributes().intensity[i]);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST(Copc, HoldsThePointsOfThePlainFile) {
    VESTIGE_SHARED_OR_SKIP(copc, "aerial/las/lone-star.copc.laz");
    VESTIGE_SHARED_OR_SKIP(plain, "aerial/las/lone-star.laz");
    const LoadedGeometry tree = readOrFail(copc);
    const LoadedGeometry flat = readOrFail(plain);
    // The two files round to grids of their own.
    ASSERT_EQ(tree.geometry.vertices.size(), flat.geometry.vertices.size());
    EXPECT_LT((tree.info.bounds.min - flat.info.bounds.min).cwiseAbs().maxCoeff(), 0.002);
    EXPECT_LT((tree.info.bounds.max - flat.info.bounds.max).cwiseAbs().maxCoeff(), 0.002);
    const auto info = fileInfo(copc);
    ASSERT_TRUE(info);
    EXPECT_NE(info->version.find("COPC"), std::string::npos) << info->version;
    for (const std::string& warning : info->warnings)
        EXPECT_EQ(warning.find("octree"), std::string::npos) << warning;
}

TEST(Copc, ABoxIsReadFromItsNodesAlone) {
    VESTIGE_SHARED_OR_SKIP(copc, "aerial/las/lone-star.copc.laz");
    const LoadedGeometry whole = readOrFail(copc);
    const Eigen::Vector3d centre = whole.geometry.vertices.point(whole.geometry.vertices.size() / 2);
    const Eigen::Vector3d extent = whole.info.bounds.extent();
    for (const double share : {0.02, 0.3}) {
        ReadOptions options;
        options.box.emplace();
        options.box->add(Eigen::Vector3d(centre - share * extent));
        options.box->add(Eigen::Vector3d(centre + share * extent));
        const auto part = readGeometry(copc, options);
        ASSERT_TRUE(part) << part.error().sentence();
        LoadedGeometry expected = whole;
        expected.heeded = false;
        applyReadOptions(options, expected);
        ASSERT_FALSE(expected.geometry.vertices.empty());
        EXPECT_EQ(places(part->geometry.vertices), places(expected.geometry.vertices));
    }
}

TEST(Copc, APreviewIsOfItsFirstLevels) {
    VESTIGE_SHARED_OR_SKIP(copc, "aerial/las/lone-star.copc.laz");
    const LoadedGeometry whole = readOrFail(copc);
    const auto format = formatOfFile(copc);
    ASSERT_TRUE(format);
    const auto preview = (*format)->preview(copc, 150000, {});
    ASSERT_TRUE(preview && *preview);
    const PointCloud& shown = (*preview)->geometry.vertices;
    EXPECT_GT(shown.size(), 1000);
    EXPECT_LE(shown.size(), 150000);
    const std::vector<Place> all = places(whole.geometry.vertices);
    for (const Place& place : places(shown)) ASSERT_TRUE(std::binary_search(all.begin(), all.end(), place));
}

TEST(Copc, PagesThatOverlapAreNotBelieved) {
    VESTIGE_SHARED_OR_SKIP(copc, "aerial/las/lone-star.copc.laz");
    const TemporaryFolder folder;
    std::string bytes = readBytes(copc);
    auto* begin = reinterpret_cast<std::byte*>(bytes.data());
    constexpr std::size_t kInfo = 375 + 54;
    const auto page = load<std::uint64_t>(begin + kInfo + 40);
    const auto size = load<std::uint64_t>(begin + kInfo + 48);
    for (std::uint64_t entry = 0; entry < size / 2 / 32; ++entry) {
        store<std::uint64_t>(begin + page + 32 * entry + 16, page + 32 * (entry + 1));
        store<std::int32_t>(begin + page + 32 * entry + 24, static_cast<std::int32_t>(size / 64 * 32));
        store<std::int32_t>(begin + page + 32 * entry + 28, -1);
    }
    writeBytes(folder / "overlapping.copc.laz", bytes);
    const auto info = fileInfo(folder / "overlapping.copc.laz");
    ASSERT_TRUE(info) << info.error().sentence();
    EXPECT_EQ(info->version.find("COPC"), std::string::npos);
    EXPECT_TRUE(std::any_of(info->warnings.begin(), info->warnings.end(), [](const std::string& text) {
        return text.find("octree") != std::string::npos;
    }));
}

TEST(Copc, AnOctreeThatDoesNotFitIsNotBelieved) {
    VESTIGE_SHARED_OR_SKIP(copc, "aerial/las/lone-star.copc.laz");
    const TemporaryFolder folder;
    const std::string bytes = readBytes(copc);
    const LoadedGeometry whole = readOrFail(copc);
    // The info record is the first: its content begins behind the header and the record's own 54 bytes.
    constexpr std::size_t kInfo = 375 + 54;
    for (const auto& [place, value] : {std::pair<std::size_t, std::uint64_t>{40, 0},
                                       {40, ~std::uint64_t{0}},
                                       {48, ~std::uint64_t{0}},
                                       {48, 33}}) {
        std::string damaged = bytes;
        store(reinterpret_cast<std::byte*>(damaged.data()) + kInfo + place, value);
        writeBytes(folder / "damaged.copc.laz", damaged);
        const LoadedGeometry read = readOrFail(folder / "damaged.copc.laz");
        EXPECT_EQ(read.geometry.vertices.size(), whole.geometry.vertices.size());
        ReadOptions options;
        options.box = whole.info.bounds;
        const auto part = readGeometry(folder / "damaged.copc.laz", options);
        ASSERT_TRUE(part) << part.error().sentence();
        EXPECT_EQ(part->geometry.vertices.size(), whole.geometry.vertices.size());
        EXPECT_TRUE(
            std::any_of(part->info.warnings.begin(), part->info.warnings.end(),
                        [](const std::string& text) { return text.find("octree") != std::string::npos; }));
    }
}
