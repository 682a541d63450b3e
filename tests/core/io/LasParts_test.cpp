// What is read of a LAS or LAZ file in part, or by several threads, is what the whole file holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/ApplyReadOptions.h"
#include "core/io/Bytes.h"
#include "core/io/LasWriter.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

struct AllThreads {
    ~AllThreads() { setThreadCount(0); }
};

/// A cloud over `extent` metres at UTM coordinates, in no order of place.
PointCloud scattered(std::size_t points, double extent) {
    Random random(3);
    PointCloudBuilder builder(Eigen::Vector3d(483000, 4375000, 100));
    for (std::size_t i = 0; i < points; ++i) {
        builder.add({483000 + std::round(1000 * extent * random.uniform()) / 1000,
                     4375000 + std::round(1000 * extent * random.uniform()) / 1000,
                     std::round(1e5 * random.uniform()) / 1000});
        builder.attributes().intensity.push_back(static_cast<float>(random.below(65536)));
        builder.attributes().color.push_back({static_cast<std::uint16_t>(random.below(65536)), 7, 9});
    }
    return std::move(builder).build();
}

std::filesystem::path written(const TemporaryFolder& folder, const std::string& name,
                              const PointCloud& cloud) {
    LasWriteOptions options;
    options.scale = Eigen::Vector3d::Constant(0.001);
    EXPECT_TRUE(writeLas(folder / name, {{&cloud, Similarity{}, 1}}, options));
    return folder / name;
}

LoadedGeometry readWith(const std::filesystem::path& file, const ReadOptions& options) {
    Result<LoadedGeometry> loaded = readGeometry(file, options);
    EXPECT_TRUE(loaded) << loaded.error().sentence();
    return loaded ? std::move(*loaded) : LoadedGeometry{};
}

void expectSamePoints(const PointCloud& a, const PointCloud& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(largestDifference(a, b), 0);
    EXPECT_EQ(a.attributes().intensity, b.attributes().intensity);
    EXPECT_EQ(a.attributes().color, b.attributes().color);
}

class LasParts : public testing::TestWithParam<const char*> {
  protected:
    std::string name() const { return std::string("cloud.") + GetParam(); }
    const TemporaryFolder folder;
};

}  // namespace

TEST_P(LasParts, AKilometreWideCloudIsExactWithoutResiduals) {
    const PointCloud cloud = scattered(60000, 3000);
    const LoadedGeometry read = readOrFail(written(folder, name(), cloud));
    const PointCloud& back = read.geometry.vertices;
    EXPECT_TRUE(back.residuals().empty());
    ASSERT_TRUE(back.grid());
    ASSERT_EQ(back.size(), cloud.size());
    const Eigen::Vector3d scale = *read.info.scale;
    const Eigen::Vector3d offset = *read.info.offset;
    for (std::size_t i = 0; i < back.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = std::round((cloud.point(i)[axis] - offset[axis]) / scale[axis]);
            ASSERT_EQ(back.point(i)[axis], steps * scale[axis] + offset[axis]) << i;
        }
    for (int axis = 0; axis < 3; ++axis) {
        double least = back.point(0)[axis];
        for (std::size_t i = 0; i < back.size(); ++i) least = std::min(least, back.point(i)[axis]);
        EXPECT_EQ(back.bounds().min[axis], least);
    }
}

TEST_P(LasParts, AHeaderThatLiesOfItsBoundsChangesNothing) {
    const PointCloud cloud = scattered(5000, 400);
    const auto file = written(folder, name(), cloud);
    const LoadedGeometry honest = readOrFail(file);
    for (const double lie : {1e9, -3e7, std::numeric_limits<double>::quiet_NaN()}) {
        std::string bytes = readBytes(file);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const std::size_t place : {179 + 16 * axis, 187 + 16 * axis})
                store(reinterpret_cast<std::byte*>(bytes.data()) + place, lie);
        writeBytes(folder / ("lying." + std::string(GetParam())), bytes);
        const LoadedGeometry read = readOrFail(folder / ("lying." + std::string(GetParam())));
        expectSamePoints(honest.geometry.vertices, read.geometry.vertices);
    }
}

TEST_P(LasParts, PartsAreThoseOfTheWhole) {
    const PointCloud cloud = scattered(150000, 100);
    const auto file = written(folder, name(), cloud);
    const LoadedGeometry whole = readOrFail(file);
    BoundingBox box;
    box.add(Eigen::Vector3d(483020, 4375010, 0));
    box.add(Eigen::Vector3d(483060, 4375090, 80));
    std::vector<ReadOptions> wishes(6);
    wishes[1].keepEvery = 7;
    wishes[2].box = box;
    wishes[3].box = box;
    wishes[3].keepEvery = 3;
    wishes[4].attributes = ReadOptions::Attributes::drawn;
    wishes[5].attributes = ReadOptions::Attributes::drawn;
    wishes[5].keepEvery = 1000000;
    for (const ReadOptions& wish : wishes) {
        LoadedGeometry expected = whole;
        expected.heeded = false;
        applyReadOptions(wish, expected);
        const LoadedGeometry part = readWith(file, wish);
        ASSERT_GT(part.geometry.vertices.size(), 0);
        expectSamePoints(expected.geometry.vertices, part.geometry.vertices);
        EXPECT_EQ(part.geometry.vertices.attributes().classification.empty(),
                  wish.attributes == ReadOptions::Attributes::drawn);
        EXPECT_EQ(part.info.points, part.geometry.vertices.size());
    }
}

TEST_P(LasParts, NoNumberOfThreadsChangesABit) {
    const AllThreads reset;
    const PointCloud cloud = scattered(260000, 700);
    const auto file = written(folder, name(), cloud);
    setThreadCount(1);
    const LoadedGeometry one = readOrFail(file);
    for (const int threads : {2, 7}) {
        setThreadCount(threads);
        const LoadedGeometry several = readOrFail(file);
        expectSamePoints(one.geometry.vertices, several.geometry.vertices);
        EXPECT_EQ(one.geometry.vertices.offsets(), several.geometry.vertices.offsets());
        EXPECT_EQ(one.geometry.vertices.attributes().gpsTime, several.geometry.vertices.attributes().gpsTime);
    }
}

TEST_P(LasParts, APreviewIsOfTheFilesOwnPointsFromEverywhereInIt) {
    const PointCloud cloud = scattered(400000, 100);
    const auto file = written(folder, name(), cloud);
    const auto format = formatOfFile(file);
    ASSERT_TRUE(format);
    const auto preview = (*format)->preview(file, 20000, {});
    ASSERT_TRUE(preview && *preview);
    const PointCloud& shown = (*preview)->geometry.vertices;
    EXPECT_GT(shown.size(), 10000);
    EXPECT_LE(shown.size(), 20000);
    const LoadedGeometry whole = readOrFail(file);
    std::set<std::tuple<double, double, double>> places;
    for (std::size_t i = 0; i < whole.geometry.vertices.size(); ++i) {
        const Eigen::Vector3d point = whole.geometry.vertices.point(i);
        places.emplace(point.x(), point.y(), point.z());
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Eigen::Vector3d point = shown.point(i);
        ASSERT_TRUE(places.contains({point.x(), point.y(), point.z()})) << i;
    }
    const Eigen::Vector3d missing = whole.info.bounds.extent() - shown.bounds().extent();
    EXPECT_LT(missing.maxCoeff(), 5)
        << "the points are in no order of place: a preview reaches nearly as far";
}

TEST_P(LasParts, APeekTellsWhatTheHeaderSays) {
    const PointCloud cloud = scattered(5000, 400);
    const auto file = written(folder, name(), cloud);
    const auto peeked = peekFile(file);
    const LoadedGeometry whole = readOrFail(file);
    ASSERT_TRUE(peeked) << peeked.error().sentence();
    EXPECT_EQ(peeked->points, 5000);
    EXPECT_EQ(peeked->format, whole.info.format);
    EXPECT_LT((peeked->bounds.min - whole.info.bounds.min).norm(), 1e-9);
    EXPECT_LT((peeked->bounds.max - whole.info.bounds.max).norm(), 1e-9);
}

TEST_P(LasParts, WhatIsWholeOfACutOffFileIsItsBeginning) {
    const PointCloud cloud = scattered(120000, 100);
    const auto file = written(folder, name(), cloud);
    const std::string bytes = readBytes(file);
    const LoadedGeometry whole = readOrFail(file);
    const auto cut = folder / ("cut." + std::string(GetParam()));
    ReadOptions salvage;
    salvage.salvage = true;
    std::size_t most = 0;
    for (const double share : {0.2, 0.5, 0.7, 0.9, 0.999}) {
        writeBytes(cut, bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
        EXPECT_FALSE(readGeometry(cut)) << share;
        const LoadedGeometry saved = readWith(cut, salvage);
        const std::size_t count = saved.geometry.vertices.size();
        ASSERT_GE(count, most);
        ASSERT_LT(count, whole.geometry.vertices.size() + (share > 0.99 ? 1 : 0));
        most = count;
        EXPECT_NE(saved.info.damage.find("of 120000 points"), std::string::npos) << saved.info.damage;
        for (std::size_t i = 0; i < count; i += 97)
            ASSERT_EQ(saved.geometry.vertices.point(i), whole.geometry.vertices.point(i))
                << share << " " << i;
    }
    EXPECT_GT(most, 50000);
    EXPECT_TRUE(readWith(file, salvage).info.damage.empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, LasParts, testing::Values("las", "laz"));

TEST(LazDecoder, ACodeBeyondItsRangeIsRefusedAndNotDecoded) {
    const TemporaryFolder folder;
    const PointCloud cloud = scattered(3000, 10);
    const std::string whole = readBytes(written(folder, "a.laz", cloud));
    const auto bytesAt = [](std::string& bytes, std::size_t at) {
        return reinterpret_cast<std::byte*>(bytes.data()) + at;
    };
    std::string copy = whole;
    const auto points = load<std::uint32_t>(bytesAt(copy, 96));
    const auto record = load<std::uint16_t>(bytesAt(copy, 105));
    const std::size_t sizes = points + 8 + record + 4;
    constexpr std::size_t kLayers = 10;  // nine of the point, one of its colour
    std::size_t layer = sizes + 4 * kLayers;
    for (std::size_t i = 0; i < kLayers; ++i) {
        const auto bytes = load<std::uint32_t>(bytesAt(copy, sizes + 4 * i));
        if (bytes >= 4) {
            std::string damaged = whole;
            store<std::uint32_t>(bytesAt(damaged, layer), 0xffffffff);
            writeBytes(folder / "damaged.laz", damaged);
            const Result<LoadedGeometry> read = readGeometry(folder / "damaged.laz");
            ASSERT_FALSE(read) << "layer " << i;
            EXPECT_EQ(read.error().code, ErrorCode::input);
        }
        layer += bytes;
    }
    // The table of chunks is coded, too.
    std::string damaged = whole;
    const auto table = load<std::int64_t>(bytesAt(copy, points));
    store<std::uint32_t>(bytesAt(damaged, static_cast<std::size_t>(table) + 8), 0xffffffff);
    writeBytes(folder / "damaged.laz", damaged);
    EXPECT_FALSE(readGeometry(folder / "damaged.laz"));
}

TEST(LazDecoder, ACodeBeyondItsRangeIsRefusedPointByPointToo) {
    VESTIGE_SHARED_OR_SKIP(laz, "aerial/las/laspy/simple.laz");
    const TemporaryFolder folder;
    std::string bytes = readBytes(laz);
    auto* begin = reinterpret_cast<std::byte*>(bytes.data());
    ASSERT_LT(load<std::uint8_t>(begin + 104) & 0x3f, 6) << "coded point by point";
    const std::size_t code = load<std::uint32_t>(begin + 96) + 8 + load<std::uint16_t>(begin + 105);
    store<std::uint32_t>(begin + code, 0xffffffff);
    writeBytes(folder / "damaged.laz", bytes);
    const Result<LoadedGeometry> read = readGeometry(folder / "damaged.laz");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::input);
}

TEST(LazSalvage, OfADamagedChunkNoPointIsTakenForWhole) {
    const TemporaryFolder folder;
    constexpr std::size_t kChunk = 50000;
    const PointCloud cloud = scattered(3 * kChunk + 700, 40);
    std::string bytes = readBytes(written(folder, "a.laz", cloud));
    const LoadedGeometry whole = readOrFail(folder / "a.laz");
    auto* begin = reinterpret_cast<std::byte*>(bytes.data());
    const auto points = load<std::uint32_t>(begin + 96);
    const auto table = static_cast<std::size_t>(load<std::int64_t>(begin + points));
    // Four chunks of about one size, the last one small: the middle of the file is in the second.
    const std::size_t middle = points + (table - points) / 2;
    for (std::size_t i = 0; i < 200000 && middle + i < table; ++i)
        bytes[middle + i] = static_cast<char>(0x5a ^ (i * 7));
    writeBytes(folder / "damaged.laz", bytes);
    const Result<LoadedGeometry> refused = readGeometry(folder / "damaged.laz");
    ASSERT_FALSE(refused) << "a layer of the third chunk is no code";
    EXPECT_TRUE(refused.error().salvageable);
    EXPECT_NE(refused.error().sentence().find("the first "), std::string::npos) << refused.error().sentence();
    ReadOptions salvage;
    salvage.salvage = true;
    const Result<LoadedGeometry> read = readGeometry(folder / "damaged.laz", salvage);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_FALSE(read->info.damage.empty());
    const PointCloud& kept = read->geometry.vertices;
    EXPECT_EQ(kept.size() % kChunk, 0);
    EXPECT_NE(refused.error().sentence().find("the first " + std::to_string(kept.size())), std::string::npos)
        << refused.error().sentence();
    ASSERT_GE(kept.size(), kChunk);
    for (std::size_t i = 0; i < kChunk; ++i) ASSERT_EQ(kept.point(i), whole.geometry.vertices.point(i)) << i;
}

TEST(LazSalvage, OfAFileOfOneDamagedChunkNothingIsOffered) {
    VESTIGE_SHARED_OR_SKIP(laz, "aerial/amsterdam/ahn/ahn_2397_9705.laz");
    const TemporaryFolder folder;
    for (const double place : {0.1, 0.4, 0.8}) {
        std::string bytes = readBytes(laz);
        const auto at = static_cast<std::size_t>(place * static_cast<double>(bytes.size()));
        for (std::size_t i = 0; i < 3000; ++i) bytes[at + i] = static_cast<char>(0x5a ^ i);
        writeBytes(folder / "damaged.laz", bytes);
        const Result<LoadedGeometry> refused = readGeometry(folder / "damaged.laz");
        ASSERT_FALSE(refused);
        EXPECT_FALSE(refused.error().salvageable) << refused.error().sentence();
        ReadOptions salvage;
        salvage.salvage = true;
        EXPECT_FALSE(readGeometry(folder / "damaged.laz", salvage));
    }
}

TEST(LasParts, ACutOffFileCanBeLookedAtBeforeItIsSalvaged) {
    const TemporaryFolder folder;
    const PointCloud cloud = scattered(3000, 10);
    const std::string bytes = readBytes(written(folder, "a.las", cloud));
    writeBytes(folder / "cut.las", bytes.substr(0, bytes.size() / 2));
    const auto peeked = peekFile(folder / "cut.las");
    ASSERT_TRUE(peeked) << peeked.error().sentence();
    EXPECT_LT(peeked->points, 1600);
    EXPECT_NE(peeked->damage.find("of the 3000 points that its header names"), std::string::npos)
        << peeked->damage;
    const auto refused = readGeometry(folder / "cut.las");
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().salvageable);
}

TEST(LasParts, APreviewOfPointsBeyondTheEarthIsRefusedAsTheWholeIs) {
    const TemporaryFolder folder;
    const PointCloud cloud = scattered(3000, 10);
    std::string bytes = readBytes(written(folder, "far.las", cloud));
    // Scales up to 1e6 are taken: they are far only for points many steps away.
    for (std::size_t axis = 0; axis < 3; ++axis)
        store(reinterpret_cast<std::byte*>(bytes.data()) + 131 + 8 * axis, 1e6);
    for (std::size_t axis = 0; axis < 3; ++axis)
        store<std::int32_t>(reinterpret_cast<std::byte*>(bytes.data()) +
                                load<std::uint32_t>(reinterpret_cast<std::byte*>(bytes.data()) + 96) +
                                4 * axis,
                            2000000000);
    writeBytes(folder / "far.las", bytes);
    EXPECT_FALSE(readGeometry(folder / "far.las"));
    const auto preview = previewFile(folder / "far.las", 1000);
    ASSERT_FALSE(preview);
    EXPECT_EQ(preview.error().code, ErrorCode::input);
}

TEST(LazBomb, MorePointsThanCompressionExplainsAreRefusedWithoutTheirMemory) {
    const TemporaryFolder folder;
    const PointCloud cloud = scattered(3000, 10);
    std::string bytes = readBytes(written(folder, "bomb.laz", cloud));
    store<std::uint64_t>(reinterpret_cast<std::byte*>(bytes.data()) + 247, std::uint64_t{1} << 40);
    writeBytes(folder / "bomb.laz", bytes);
    const Result<LoadedGeometry> bomb = readGeometry(folder / "bomb.laz");
    ASSERT_FALSE(bomb);
    EXPECT_EQ(bomb.error().code, ErrorCode::input);
    EXPECT_NE(bomb.error().sentence().find("more than the compressed bytes"), std::string::npos)
        << bomb.error().sentence();
}

TEST(LasParts, ALostChunkTableIsDamageAlsoWhereAllPointsAreWhole) {
    const TemporaryFolder folder;
    const PointCloud cloud = scattered(300, 50);
    const auto file = written(folder, "a.laz", cloud);
    std::string bytes = readBytes(file);
    auto* begin = reinterpret_cast<std::byte*>(bytes.data());
    const auto table = load<std::int64_t>(begin + load<std::uint32_t>(begin + 96));
    store<std::uint32_t>(begin + table + 4, 0);
    writeBytes(file, bytes);
    EXPECT_FALSE(readGeometry(file));
    ReadOptions salvage;
    salvage.salvage = true;
    const LoadedGeometry read = readWith(file, salvage);
    EXPECT_EQ(read.geometry.vertices.size(), 300);
    EXPECT_NE(read.info.damage.find("all 300 points could be read without it"), std::string::npos)
        << read.info.damage;
}
