// Chunks packed in layers, which Vestige unpacks itself, hold what LASzip finds in them.
#include <gtest/gtest.h>

#include <bit>
#include <sstream>

#include "core/base/Random.h"
#include "core/io/Bytes.h"
#include "core/io/LasWriter.h"
#include "core/io/formats/LasEncode.h"
#include "core/io/formats/LazReader.h"
#include "core/io/formats/LazWriter.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};

enum class With { ours, laszip };

struct Points {
    std::vector<LasPoint> read;
    std::string refusal;
};

/// The points of a LAZ file that the checks find no fault with.
class LazBytes {
  public:
    explicit LazBytes(std::string bytes) : bytes_(std::move(bytes)), job_("cloud.laz", control_) {
        try {
            header_ = parseLasHeader(span(), job_);
            plan_ = planLaz(span(), header_, job_, false);
            sound_ = true;
        } catch (const ErrorException& problem) {
            EXPECT_EQ(problem.error.code, ErrorCode::input);
        }
    }
    bool sound() const { return sound_; }
    bool isOurs() const { return !plan_.chunks.empty(); }
    const LazPlan& plan() const { return plan_; }
    std::uint64_t size() const { return header_.points; }
    /// To be changed after the checks.
    std::string& bytes() { return bytes_; }

    Points points(With reader, bool drawn, std::uint64_t begin = 0, std::uint64_t end = kAll) const {
        LazPlan plan = plan_;
        if (reader == With::laszip) plan.chunks.clear();
        Points points;
        std::uint64_t expected = begin;
        try {
            readLazPoints(span(), header_, plan, drawn, begin, std::min(end, size()), job_,
                          [&](std::uint64_t first, std::span<const LasPoint> block) {
                              EXPECT_EQ(first, expected);
                              points.read.insert(points.read.end(), block.begin(), block.end());
                              expected += block.size();
                          });
        } catch (const ErrorException& problem) {
            points.refusal = problem.error.sentence();
        }
        return points;
    }

  private:
    std::span<const std::byte> span() const { return std::as_bytes(std::span(bytes_)); }

    std::string bytes_;
    JobControl control_;
    ReadJob job_;
    LasHeader header_;
    LazPlan plan_;
    bool sound_ = false;
};

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

/// What a scanner would not write all at once: every field changes, slowly, by leaps, or not at all.
class WildScanner {
  public:
    explicit WildScanner(std::uint64_t seed, bool oneChannel = false)
        : random_(seed), oneChannel_(oneChannel) {}

    std::vector<std::byte> next() {
        if (random_.below(2000) == 0) calm_ = random_.below(7);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const unsigned bits = random_.below(calm_ == 0 ? 33 : 12);
            store<std::uint32_t>(at(4 * axis), load<std::uint32_t>(at(4 * axis)) + spread(bits));
        }
        if (may(3)) put<std::uint16_t>(12, 1 + calm_ * 9000);
        if (may(2)) put<std::uint8_t>(14, 256);
        std::uint8_t flags = load<std::uint8_t>(at(15));
        if (may(4)) flags = static_cast<std::uint8_t>(random_.below(256));
        if (oneChannel_) flags = static_cast<std::uint8_t>((flags & 0xcfU) | 16U);
        store<std::uint8_t>(at(15), flags);
        if (may(4)) put<std::uint8_t>(16, 256);
        if (may(5)) put<std::uint8_t>(17, 256);
        if (may(5)) put<std::int16_t>(18, 30000);
        if (may(6)) put<std::uint16_t>(20, 65536);
        time();
        for (std::size_t i = 0; i < 3; ++i)
            if (may(2)) put<std::uint16_t>(30 + 2 * i, calm_ % 2 == 0 ? 65536 : 256);
        if (may(5))
            for (std::size_t i = 1; i < 3; ++i) store(at(30 + 2 * i), load<std::uint16_t>(at(30)));
        return record_;
    }

  private:
    std::byte* at(std::size_t place) { return record_.data() + place; }
    bool may(unsigned rarity) { return random_.below(1 + rarity * calm_) == 0; }
    std::uint32_t spread(unsigned bits) {
        const std::uint64_t reach = std::uint64_t{1} << bits;
        return static_cast<std::uint32_t>(random_.below(reach)) - static_cast<std::uint32_t>(reach / 2);
    }
    template <class Number>
    void put(std::size_t place, std::uint64_t below) {
        store(at(place), static_cast<Number>(random_.below(below)));
    }
    /// Steady pulses, their multiples, several scanners by turns, leaps, and bits that are no time.
    void time() {
        const std::size_t clock = random_.below(calm_ < 3 ? 6 : 1);
        double& now = clocks_[clock];
        switch (random_.below(calm_ == 0 ? 12 : 5)) {
            case 0:
                break;
            case 1:
                now += 1e-5;
                break;
            case 2:
                now += 1e-5 * static_cast<double>(random_.below(600));
                break;
            case 3:
                now -= 1e-5 * static_cast<double>(random_.below(14));
                break;
            case 4:
                now += 1e-5 + 1e-9 * random_.uniform();
                break;
            case 5:
                now += 1000 * random_.uniform();
                break;
            case 6:
                store<std::uint64_t>(at(22), random_.below(~std::uint64_t{0}));
                return;
            default:
                break;
        }
        store(at(22), now);
    }

    Random random_;
    bool oneChannel_;
    unsigned calm_ = 1;
    std::array<double, 6> clocks_{1e8, 1e8 + 7, 2e8, 3.5, -4e5, 1.5e8};
    std::vector<std::byte> record_ = std::vector<std::byte>(36);
};

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
