#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/TileFiles.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

std::vector<std::filesystem::path> samples() {
    std::vector<std::filesystem::path> files;
    const auto folder = sharedFile("formats/pnts");
    if (!folder) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder))
        if (entry.path().extension() == ".pnts") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void expectReadOrRefused(const std::filesystem::path& file, std::size_t most, const std::string& what) {
    const Result<LoadedGeometry> loaded = readGeometry(file);
    if (loaded) {
        EXPECT_LE(loaded->geometry.vertices.size(), most) << what;
    } else {
        EXPECT_EQ(loaded.error().code, ErrorCode::input) << what;
        EXPECT_NE(loaded.error().place.find(file.string()), std::string::npos) << loaded.error().sentence();
    }
}

void expectRefused(const std::filesystem::path& file, const std::string& content, const std::string& part) {
    writeBytes(file, content);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    ASSERT_FALSE(loaded) << part;
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    EXPECT_NE(loaded.error().sentence().find(part), std::string::npos) << loaded.error().sentence();
    EXPECT_NE(loaded.error().hint.find("expected: "), std::string::npos) << loaded.error().sentence();
}

const std::string kThree = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 2, 0});
const std::string kPosition = R"("POSITION":{"byteOffset":0})";

}  // namespace

TEST(PntsHostile, EveryVariantCutOffAnywhereIsRefusedOrSalvaged) {
    if (samples().empty()) GTEST_SKIP() << "skipped: formats/pnts is not on this machine";
    const TemporaryFolder folder;
    const auto cut = folder / "cut.pnts";
    ReadOptions salvage;
    salvage.salvage = true;
    for (const auto& file : samples()) {
        const std::string whole = readBytes(file);
        const PointCloud reference = readOrFail(file).geometry.vertices;
        for (std::size_t length = 1; length < whole.size(); length += 1 + length / 12) {
            writeBytes(cut, whole.substr(0, length));
            EXPECT_FALSE(readGeometry(cut)) << file << " " << length;
            const auto saved = readGeometry(cut, salvage);
            if (!saved) continue;
            EXPECT_NE(saved->info.damage.find("ends early"), std::string::npos) << saved->info.damage;
            ASSERT_LE(saved->geometry.vertices.size(), reference.size());
            for (std::size_t i = 0; i < saved->geometry.vertices.size(); ++i)
                ASSERT_EQ(saved->geometry.vertices.point(i), reference.point(i));
        }
    }
}

TEST(PntsHostile, HalfThePositionsAreSalvaged) {
    const auto file = sharedFile("formats/pnts/PointCloud/PointCloudRGB/pointCloudRGB.pnts");
    if (!file) GTEST_SKIP() << "skipped: formats/pnts is not on this machine";
    const TemporaryFolder folder;
    writeBytes(folder / "half.pnts", readBytes(*file).substr(0, 28 + 148 + 500 * 12 + 7));
    ReadOptions salvage;
    salvage.salvage = true;
    const auto saved = readGeometry(folder / "half.pnts", salvage);
    ASSERT_TRUE(saved) << saved.error().sentence();
    EXPECT_EQ(saved->geometry.vertices.size(), 500);
    EXPECT_EQ(saved->info.damage,
              "the file ends early: 500 of 1000 points were read; without RGB, the batch table");
}

TEST(PntsHostile, WrongBytesAreReadOrRefused) {
    if (samples().empty()) GTEST_SKIP() << "skipped: formats/pnts is not on this machine";
    const TemporaryFolder folder;
    const auto wrong = folder / "wrong.pnts";
    std::uint64_t seed = 0;
    for (const auto& file : samples()) {
        const std::string whole = readBytes(file);
        // The head, where the promises stand, and the Draco streams deserve the most.
        const std::size_t head = std::min<std::size_t>(whole.size(), 900);
        const bool draco = whole.find("DRACO") != std::string::npos;
        for (std::uint64_t round = 0; round < (draco ? 300 : 40); ++round) {
            Random random(++seed, round);
            std::string damaged = whole;
            for (std::uint64_t i = 0; i <= random.below(4); ++i)
                damaged[random.below(round % 3 == 0 ? whole.size() : head)] =
                    static_cast<char>(random.below(256));
            writeBytes(wrong, damaged);
            expectReadOrRefused(wrong, 1000, file.filename().string() + " " + std::to_string(round));
        }
    }
}

TEST(PntsHostile, PromisesThatTheFileCannotKeepAreRefused) {
    const TemporaryFolder folder;
    const auto file = folder / "a.pnts";
    const auto tile = [](const std::string& feature, const std::string& batch = {}) {
        return pntsBytes("{" + feature + "}", kThree, batch.empty() ? batch : "{" + batch + "}");
    };
    expectRefused(file, "pnts", "byte 4");
    expectRefused(file, "pnts" + bytesOf<std::uint32_t>({2, 28, 0, 0, 0, 0}), "version 2");
    expectRefused(file, "pnts" + bytesOf<std::uint32_t>({1, 28, 4000000000, 4000000000, 0, 0}), "byte 12");
    expectRefused(file, "pnts" + bytesOf<std::uint32_t>({1, 4000000000, 8, 3999999000, 0, 0}) + "{}      ",
                  "the file ends inside the point tile");
    expectRefused(file, tile(kPosition), "POINTS_LENGTH");
    expectRefused(file, tile(R"("POINTS_LENGTH":3)"), "no positions");
    expectRefused(file, tile(R"("POINTS_LENGTH":4000000000,)" + kPosition), "POSITION needs 4000000000");
    expectRefused(file, tile(R"("POINTS_LENGTH":4e18,)" + kPosition), "POINTS_LENGTH");
    expectRefused(file, tile(R"("POINTS_LENGTH":-1,)" + kPosition), "POINTS_LENGTH is -1");
    expectRefused(file, tile(R"("POINTS_LENGTH":1.5,)" + kPosition), "POINTS_LENGTH is 1.5");
    expectRefused(file, tile(R"("POINTS_LENGTH":"3",)" + kPosition), "POINTS_LENGTH");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,"POSITION":{"byteOffset":8})"), "from offset 8");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,"POSITION":{"byteOffset":9e15})"), "POSITION needs");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,"POSITION":{})"), "byteOffset");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,"RTC_CENTER":[1,2],)" + kPosition), "RTC_CENTER");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,"RTC_CENTER":[1,2,1e999],)" + kPosition), "number");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,"POSITION_QUANTIZED":{"byteOffset":0})"), "no volume");
    expectRefused(file, tile(R"("POINTS_LENGTH":3,)" + kPosition, R"("a":{"byteOffset":0,"type":"MAT"})"),
                  "no known type");
    expectRefused(file,
                  tile(R"("POINTS_LENGTH":3,)" + kPosition,
                       R"("a":{"byteOffset":0,"componentType":"FLOAT","type":"SCALAR"})"),
                  "a needs 3 values");
    expectRefused(file,
                  tile(R"("POINTS_LENGTH":3,"BATCH_LENGTH":1,"BATCH_ID":{"byteOffset":10},)" + kPosition,
                       R"("intensity":[1])"),
                  "is of batch");
    expectRefused(file,
                  pntsBytes(R"({"POINTS_LENGTH":3,"BATCH_LENGTH":2,)"
                            R"("BATCH_ID":{"byteOffset":36,"componentType":"SHORT"},)" +
                                kPosition + "}",
                            kThree + bytesOf<std::int16_t>({0, 1, -1}), R"({"intensity":[1,2]})"),
                  "point 3 is of batch -1");
    expectRefused(file, pntsBytes("[1,2]", kThree), "no object");
    expectRefused(file, pntsBytes("{\"POINTS_LENGTH\":3", kThree), "not JSON");
    expectRefused(file, pntsBytes(std::string(5000, '[') + std::string(5000, ']'), kThree), "nested 5000");
    expectRefused(file,
                  pntsBytes("{\"POINTS_LENGTH\":1," + kPosition + "}",
                            bytesOf<float>({0, std::numeric_limits<float>::quiet_NaN(), 0})),
                  "no finite number");
}

TEST(PntsHostile, DracoStreamsAreCheckedBeforeTheDecoderSeesThem) {
    const auto source = sharedFile("formats/pnts/PointCloud/PointCloudDraco/pointCloudDraco.pnts");
    if (!source) GTEST_SKIP() << "skipped: formats/pnts is not on this machine";
    const TemporaryFolder folder;
    const std::string whole = readBytes(*source);
    const std::size_t stream = whole.find("DRACO");
    ASSERT_NE(stream, std::string::npos);
    const auto patched = [&](std::size_t at, const std::string& bytes) {
        std::string content = whole;
        return content.replace(at, bytes.size(), bytes);
    };
    const auto file = folder / "a.pnts";
    expectRefused(file, patched(stream, "draco"), "no Draco stream");
    expectRefused(file, patched(stream + 5, "\1"), "version 1.");
    expectRefused(file, patched(stream + 7, "\1"), "a mesh");
    expectRefused(file, patched(stream + 8, "\7"), "method 7");
    expectRefused(file, patched(stream + 10, "\x80"), "metadata");
    expectRefused(file, patched(stream + 11, "\377\377\377\77"), "promises");
    expectRefused(file, patched(stream + 11, std::string("\351\3\0\0", 4)), "1001");
    expectRefused(file, patched(stream + 16, "\101"), "65 attributes");
    // The table asks for attributes that the stream does not have, or has of another type.
    expectRefused(file, patched(whole.find("\"NORMAL\":2"), "\"NORMAL\":9"), "no attribute 9");
    expectRefused(file, patched(whole.find("\"NORMAL\":2"), "\"NORMAL\":1"), "another type");
    expectRefused(file, patched(whole.find("\"byteLength\":15300"), "\"byteLength\":15309"), "Draco stream");
}
