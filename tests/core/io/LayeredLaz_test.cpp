// Chunks packed in layers, which Vestige unpacks itself, hold what LASzip finds in them.
#include <gtest/gtest.h>

#include <bit>
#include <sstream>

#include "core/io/LasWriter.h"
#include "core/io/formats/LasEncode.h"
#include "core/io/formats/LazWriter.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/LazBytes.h"
#include "tests/core/io/WildScanner.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

bool same(const LasPoint& a, const LasPoint& b) {
    return a.steps == b.steps && a.intensity == b.intensity && a.returnNumber == b.returnNumber &&
           a.returnCount == b.returnCount && a.classification == b.classification &&
           a.withheld == b.withheld && a.pointSource == b.pointSource && a.color == b.color &&
           std::bit_cast<std::uint64_t>(a.gpsTime) == std::bit_cast<std::uint64_t>(b.gpsTime);
}

/// Where the shorter of both ends, or the first difference.
std::size_t commonLength(const Points& a, const Points& b) {
    const std::size_t least = std::min(a.read.size(), b.read.size());
    for (std::size_t i = 0; i < least; ++i)
        if (!same(a.read[i], b.read[i])) return i;
    return least;
}

void expectAsLaszip(const LazBytes& file) {
    ASSERT_TRUE(file.sound());
    ASSERT_TRUE(file.isOurs());
    for (const bool drawn : {false, true}) {
        const Points ours = file.points(With::ours, drawn);
        const Points laszip = file.points(With::laszip, drawn);
        ASSERT_EQ(laszip.refusal, "");
        ASSERT_EQ(ours.refusal, "");
        ASSERT_EQ(ours.read.size(), file.size());
        ASSERT_EQ(commonLength(ours, laszip), file.size()) << (drawn ? "drawn" : "all");
    }
}

std::string packed(WildScanner scanner, std::size_t points, bool colored) {
    std::ostringstream stream;
    LazWriter writer(colored);
    const auto write = [&](const std::vector<std::byte>& bytes) {
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    };
    write(std::vector<std::byte>(kLasHeaderSize));
    write(writer.record());
    LasPlan plan;
    plan.colored = colored;
    plan.compressed = true;
    plan.pointOffset = static_cast<std::size_t>(stream.tellp());
    plan.records = 1;
    writer.open(stream);
    for (std::size_t i = 0; i < points; ++i) writer.add(scanner.next());
    writer.close();
    LasTotals totals;
    totals.points = points;
    totals.bounds.add(Eigen::Vector3d::Zero());
    stream.seekp(0);
    write(encodeHeader({}, plan, {Eigen::Vector3d::Constant(0.001), Eigen::Vector3d::Zero()}, totals));
    return stream.str();
}

/// Where the first chunk is, behind the place of the chunk table.
std::size_t firstChunk(const std::string& bytes) {
    return load<std::uint32_t>(reinterpret_cast<const std::byte*>(bytes.data()) + 96) + 8;
}

/// LASzip's version of all items, which its record names.
std::string asVersion(std::string bytes, std::uint16_t version, bool colored) {
    auto* items = reinterpret_cast<std::byte*>(bytes.data()) + kLasHeaderSize + 54 + 34;
    for (int item = 0; item < (colored ? 2 : 1); ++item) {
        EXPECT_EQ(load<std::uint16_t>(items + 6 * item + 4), 3);
        store(items + 6 * item + 4, version);
    }
    return bytes;
}

}  // namespace

TEST(LayeredLaz, RealFilesOfLayersHoldWhatLaszipFinds) {
    VESTIGE_SHARED_OR_SKIP(copc, "aerial/las/lone-star.copc.laz");
    expectAsLaszip(LazBytes(readBytes(copc)));
    VESTIGE_SHARED_OR_SKIP(extra, "aerial/las/las_with_several_extra_byte_bloc.laz");
    expectAsLaszip(LazBytes(readBytes(extra)));
}

TEST(LayeredLaz, OtherRealFilesPackedAnewHoldWhatLaszipFinds) {
    const TemporaryFolder folder;
    for (const char* name : {"aerial/brighton/model.laz", "aerial/amsterdam/ahn/ahn_2397_9705.laz",
                             "aerial/las/autzen_trim.laz", "aerial/las/lone-star.laz"}) {
        VESTIGE_SHARED_OR_SKIP(file, name);
        const LoadedGeometry loaded = readOrFail(file);
        ASSERT_TRUE(writeLas(folder / "anew.laz", {{&loaded.geometry.vertices, Similarity{}, 1}}, {}));
        expectAsLaszip(LazBytes(readBytes(folder / "anew.laz")));
    }
}

TEST(LayeredLaz, WildAttributesOfAllChannelsAreThoseThatLaszipFinds) {
    for (const bool colored : {false, true})
        for (const bool oneChannel : {false, true})
            expectAsLaszip(LazBytes(packed(WildScanner(7, oneChannel), 120000, colored)));
}

TEST(LayeredLaz, FewPointsAreThoseThatLaszipFinds) {
    for (const std::size_t points : {1, 2, 3, 255, 256, 257, 50000, 50001})
        expectAsLaszip(LazBytes(packed(WildScanner(points), points, true)));
}

TEST(LayeredLaz, WhatIsReadIsWhatWasWritten) {
    const LazBytes file(packed(WildScanner(21), 60000, true));
    const Points points = file.points(With::ours, false);
    WildScanner scanner(21);
    ASSERT_EQ(points.read.size(), 60000);
    for (std::size_t i = 0; i < points.read.size(); ++i) {
        const std::vector<std::byte> record = scanner.next();
        const LasPoint& point = points.read[i];
        ASSERT_EQ(point.steps[2], load<std::int32_t>(record.data() + 8)) << i;
        ASSERT_EQ(point.classification, load<std::uint8_t>(record.data() + 16)) << i;
        ASSERT_EQ(point.pointSource, load<std::uint16_t>(record.data() + 20)) << i;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(point.gpsTime), load<std::uint64_t>(record.data() + 22)) << i;
        ASSERT_EQ(point.color[2], load<std::uint16_t>(record.data() + 34)) << i;
    }
}

TEST(LayeredLaz, RangesThatBeginWithinChunksAreParts) {
    const LazBytes file(packed(WildScanner(3), 120000, true));
    const Points whole = file.points(With::ours, false);
    ASSERT_EQ(whole.read.size(), 120000);
    const std::vector<std::pair<int, int>> ranges{
        {1, 2}, {255, 257}, {300, 40000}, {49999, 50001}, {50000, 50000}, {60001, 119999}, {119999, 120000}};
    for (const auto& [begin, end] : ranges) {
        const Points part = file.points(With::ours, false, static_cast<std::uint64_t>(begin),
                                        static_cast<std::uint64_t>(end));
        ASSERT_EQ(part.read.size(), static_cast<std::size_t>(end - begin));
        for (std::size_t i = 0; i < part.read.size(); ++i)
            ASSERT_TRUE(same(part.read[i], whole.read[static_cast<std::size_t>(begin) + i]))
                << begin << " " << i;
    }
}

TEST(LayeredLaz, Version4DiffersInNothingForOneChannel) {
    // The versions differ in the models of colours after a change of channel. Read as the other version,
    // several channels give other points, which must be the same others.
    expectAsLaszip(LazBytes(asVersion(packed(WildScanner(5, true), 60000, false), 4, false)));
    const LazBytes file(asVersion(packed(WildScanner(5), 60000, true), 4, true));
    ASSERT_TRUE(file.isOurs());
    const Points ours = file.points(With::ours, false);
    const Points laszip = file.points(With::laszip, false);
    EXPECT_GE(ours.read.size() + 256, laszip.read.size());
    EXPECT_EQ(commonLength(ours, laszip), std::min(ours.read.size(), laszip.read.size()));
}

TEST(LayeredLaz, DamagedChunksAreRefusedOrReadAsLaszipReadsThem) {
    const std::string whole = packed(WildScanner(11), 3000, true);
    const std::size_t begin = firstChunk(whole);
    Random random(5);
    int read = 0;
    int refused = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::string bytes = whole;
        const std::uint64_t changes = 1 + random.below(3);
        for (std::uint64_t i = 0; i < changes; ++i)
            bytes[begin + random.below(bytes.size() - begin)] = static_cast<char>(random.below(256));
        const LazBytes file(asVersion(bytes, trial % 2 == 0 ? 3 : 4, true));
        if (!file.sound() || !file.isOurs()) continue;
        const bool drawn = random.below(2) == 0;
        const Points ours = file.points(With::ours, drawn);
        const Points laszip = file.points(With::laszip, drawn);
        ASSERT_EQ(commonLength(ours, laszip), std::min(ours.read.size(), laszip.read.size())) << trial;
        // Scan angle and user data are passed over, so that damage to them is not seen.
        if (drawn || laszip.refusal.empty()) {
            ASSERT_EQ(ours.refusal.empty(), laszip.refusal.empty()) << trial;
            ASSERT_EQ(ours.read.size(), ours.refusal.empty() ? file.size() : laszip.read.size() / 256 * 256);
        }
        if (!ours.refusal.empty()) {
            ASSERT_NE(ours.refusal.find("cloud.laz, byte "), std::string::npos) << ours.refusal;
        }
        ++(ours.refusal.empty() ? read : refused);
    }
    EXPECT_GT(read, 20);
    EXPECT_GT(refused, 20);
}

TEST(LayeredLaz, ALayerThatEndsEarlyIsRefused) {
    std::string bytes = packed(WildScanner(2), 20000, true);
    std::byte* sizes = reinterpret_cast<std::byte*>(bytes.data()) + firstChunk(bytes) + 36 + 4;
    // The end of each layer goes to the next one.
    for (std::size_t layer = 0; layer < 9; ++layer) {
        const auto size = load<std::uint32_t>(sizes + 4 * layer);
        const auto behind = load<std::uint32_t>(sizes + 4 * layer + 4);
        ASSERT_GT(size, 400);
        store(sizes + 4 * layer, size - 300);
        store(sizes + 4 * layer + 4, behind + 300);
        const LazBytes file(bytes);
        if (file.isOurs()) {
            const bool passedOver = layer == 5 || layer == 6;  // scan angle and user data
            const Points ours = file.points(With::ours, false);
            const Points laszip = file.points(With::laszip, false);
            EXPECT_EQ(ours.refusal.empty(), passedOver) << layer;
            EXPECT_EQ(commonLength(ours, laszip), std::min(ours.read.size(), laszip.read.size())) << layer;
            if (!passedOver) {
                EXPECT_EQ(ours.read.size(), laszip.read.size() / 256 * 256) << layer;
            }
        }
        store(sizes + 4 * layer, size);
        store(sizes + 4 * layer + 4, behind);
    }
}

TEST(LayeredLaz, AFileThatChangesAfterTheChecksIsRefused) {
    const std::string whole = packed(WildScanner(2), 70000, true);
    const std::size_t begin = firstChunk(whole);
    for (const std::size_t place : {begin + 36, begin + 36 + 4, begin + 36 + 4 + 36})
        for (const std::uint32_t number : {0U, 1U, 0x7fffffffU, 0xffffffffU}) {
            LazBytes file(whole);
            ASSERT_TRUE(file.isOurs());
            store(reinterpret_cast<std::byte*>(file.bytes().data()) + place, number);
            const Points points = file.points(With::ours, false);
            EXPECT_TRUE(!points.refusal.empty() || points.read.size() == 70000) << place - begin;
        }
}

TEST(LayeredLaz, WhereTableAndChunksDisagreeLaszipDecides) {
    std::string bytes = packed(WildScanner(2), 170000, false);
    ASSERT_TRUE(LazBytes(bytes).isOurs());
    auto* begin = reinterpret_cast<std::byte*>(bytes.data());
    const auto table = static_cast<std::size_t>(load<std::int64_t>(begin + firstChunk(bytes) - 8));
    store<std::uint8_t>(begin + table + 9, load<std::uint8_t>(begin + table + 9) ^ 4U);
    const LazBytes file(bytes);
    EXPECT_TRUE(file.sound());
    EXPECT_FALSE(file.isOurs());
}
