#include <gtest/gtest.h>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

TEST(RealFiles, LasAndLazOfEqualContentReadEqual) {
    VESTIGE_SHARED_OR_SKIP(las, "aerial/las/autzen_trim.las");
    VESTIGE_SHARED_OR_SKIP(laz, "aerial/las/autzen_trim.laz");
    VESTIGE_SHARED_OR_SKIP(las14, "aerial/las/autzen_trim_7.las");
    const LoadedGeometry reference = readOrFail(las);
    ASSERT_EQ(reference.geometry.vertices.size(), 110000);
    for (const auto& file : {laz, las14}) {
        const LoadedGeometry other = readOrFail(file);
        EXPECT_EQ(largestDifference(reference.geometry.vertices, other.geometry.vertices), 0);
        expectSameAttributes(reference.geometry.vertices, other.geometry.vertices);
        EXPECT_EQ(reference.info.attributes, other.info.attributes);
    }
}

TEST(RealFiles, UtmCoordinatesSurviveEveryFormatAndBack) {
    VESTIGE_SHARED_OR_SKIP(source, "aerial/brighton/model.laz");
    const TemporaryFolder folder;
    const LoadedGeometry original = readOrFail(source);
    ASSERT_EQ(original.geometry.vertices.size(), 940393);
    for (const char* extension : {"las", "laz", "ply", "pcd", "csv", "xyz"}) {
        const auto file = folder / (std::string("there.") + extension);
        const Status written = writeGeometry(file, original.geometry, {&original.info});
        ASSERT_TRUE(written) << written.error().sentence();
        const LoadedGeometry there = readOrFail(file);
        EXPECT_LT(largestDifference(original.geometry.vertices, there.geometry.vertices), 5e-5) << extension;
        expectSameAttributes(original.geometry.vertices, there.geometry.vertices);
        ASSERT_TRUE(writeGeometry(folder / "back.las", there.geometry, {&there.info}));
        EXPECT_LT(
            largestDifference(original.geometry.vertices, readOrFail(folder / "back.las").geometry.vertices),
            1e-4)
            << extension;
        std::filesystem::remove(file);
    }
}
