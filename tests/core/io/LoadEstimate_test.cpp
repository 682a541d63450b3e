#include "core/io/LoadEstimate.h"

#include <gtest/gtest.h>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

FileInfo promising(std::uint64_t points, std::uint64_t heldToRead = 0) {
    FileInfo info;
    info.points = points;
    info.heldToRead = heldToRead;
    return info;
}

}  // namespace

TEST(LoadEstimate, OffersTheThinningThatFits) {
    const std::uint64_t free = availableMemory();
    const std::uint64_t points = free / 10;  // four times what fits
    const LoadEstimate whole = estimateLoad(promising(points), {});
    ASSERT_FALSE(whole.fits());
    EXPECT_TRUE(whole.partsHelp);
    EXPECT_NE(whole.sentence().find("GB"), std::string::npos);
    ReadOptions thinned;
    thinned.keepEvery = whole.keepEveryToFit + 1;  // what is free changes a little meanwhile
    EXPECT_TRUE(estimateLoad(promising(points), thinned).fits());
}

TEST(LoadEstimate, APartOfAFormatThatIsReadWholeCostsTheWhole) {
    const std::uint64_t points = availableMemory() / 10;
    ReadOptions thinned;
    thinned.keepEvery = 1000;
    EXPECT_TRUE(estimateLoad(promising(points), thinned).fits());
    const LoadEstimate estimate = estimateLoad(promising(points, points), thinned);
    EXPECT_FALSE(estimate.fits());
    EXPECT_FALSE(estimate.partsHelp);
}

TEST(LoadEstimate, AHeaderMayPromiseAnything) {
    const LoadEstimate estimate = estimateLoad(promising(~std::uint64_t{0}, ~std::uint64_t{0}), {});
    EXPECT_FALSE(estimate.fits());
    EXPECT_GT(estimate.bytes, std::uint64_t{1} << 40);
}

TEST(LoadEstimate, FormatsSayWhetherTheyReadParts) {
    const TemporaryFolder folder;
    for (const char* name : {"a.las", "a.ply"})
        ASSERT_TRUE(writeGeometry(folder / name, {fullCloud(40, true), {}}));
    EXPECT_EQ(peekFile(folder / "a.las")->heldToRead, 0);
    EXPECT_EQ(peekFile(folder / "a.ply")->heldToRead, 40);
}
