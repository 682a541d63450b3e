#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/E57Craft.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

const std::string kDoubles =
    "<cartesianX type=\"Float\"/><cartesianY type=\"Float\"/><cartesianZ type=\"Float\"/>";

std::string threePoints() {
    return E57Craft::packet(
        {bytesOf<double>({1, 2, 3}), bytesOf<double>({10, 20, 30}), bytesOf<double>({0.5, 0.25, 0.125})});
}

Result<LoadedGeometry> readBack(const std::string& bytes, const ReadOptions& options = {}) {
    const TemporaryFolder folder;
    writeBytes(folder / "made.e57", bytes);
    return readGeometry(folder / "made.e57", options);
}

/// Expects the file to be refused with a sentence that says this, at a byte.
void expectRefused(const std::string& bytes, const std::string& says) {
    const Result<LoadedGeometry> read = readBack(bytes);
    ASSERT_FALSE(read) << says;
    EXPECT_EQ(read.error().code, ErrorCode::input);
    EXPECT_NE(read.error().message.find(says), std::string::npos) << read.error().sentence();
    EXPECT_NE(read.error().place.find(", byte "), std::string::npos) << read.error().sentence();
}

}  // namespace

TEST(E57Hostile, SphericalPointsInTheirPoseWithoutTheInvalidOnes) {
    E57Craft craft;
    const double quarter = std::acos(-1.0) / 2;
    const std::uint64_t at = craft.section(
        E57Craft::packet({bytesOf<double>({2, 4, 1, 8}), bytesOf<double>({0, quarter, 0, 0}),
                          bytesOf<double>({0, 0, 0, quarter}), bytesOf<std::uint8_t>({0b00010000}),
                          bytesOf<std::uint16_t>({5, 6, 7, 8})}));
    const std::string prototype =
        "<sphericalRange type=\"Float\"/><sphericalAzimuth type=\"Float\"/><sphericalElevation "
        "type=\"Float\"/><sphericalInvalidState type=\"Integer\" minimum=\"0\" maximum=\"2\"/>"
        "<intensity type=\"ScaledInteger\" minimum=\"0\" maximum=\"65535\" scale=\"0.5\" offset=\"1\"/>";
    // A quarter turn about z, then moved.
    const std::string pose =
        "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">0.70710678118654757</w>"
        "<x type=\"Float\"/><y type=\"Float\"/><z type=\"Float\">0.70710678118654757</z></rotation>"
        "<translation type=\"Structure\"><x type=\"Float\">500000</x><y type=\"Float\">5e6</y>"
        "<z type=\"Float\">100</z></translation></pose>";
    const Result<LoadedGeometry> read = readBack(craft.file(E57Craft::root(E57Craft::scan(
        at, 4, prototype, "<name type=\"String\"><![CDATA[Gr\xc3\xb6\xc3\x9f]]></name>" + pose))));
    ASSERT_TRUE(read) << read.error().sentence();
    const PointCloud& cloud = read->geometry.vertices;
    ASSERT_EQ(cloud.size(), 3);
    EXPECT_LT((cloud.point(0) - Eigen::Vector3d(500000, 5000002, 100)).norm(), 1e-8);
    EXPECT_LT((cloud.point(1) - Eigen::Vector3d(499996, 5000000, 100)).norm(), 1e-8);
    EXPECT_LT((cloud.point(2) - Eigen::Vector3d(500000, 5000000, 108)).norm(), 1e-8);
    EXPECT_EQ(cloud.attributes().intensity[1], 4);
    EXPECT_EQ(cloud.attributes().intensity[2], 5);
    ASSERT_EQ(read->info.warnings.size(), 1);
    EXPECT_NE(read->info.warnings[0].find("1 record without a position"), std::string::npos);
    EXPECT_EQ(read->info.scans[0].points, 3);
    EXPECT_EQ(read->info.scans[0].name, "Gr\xc3\xb6\xc3\x9f");
}

TEST(E57Hostile, BitsGoOnFromOnePacketToTheNext) {
    // 12 bits a value: the second begins in the middle of a byte, and so does the second packet.
    E57Craft craft;
    const std::string prototype =
        "<cartesianX type=\"Integer\" minimum=\"-1000\" maximum=\"3000\"/><cartesianY type=\"Float\" "
        "precision=\"single\"/><label type=\"String\"/><cartesianZ type=\"Integer\" minimum=\"7\" "
        "maximum=\"7\"/>";
    const std::uint64_t at = craft.section(
        E57Craft::packet({std::string("\x01\x20", 2), bytesOf<float>({1.5F}),
                          "\x02"
                          "a",
                          ""}) +
        E57Craft::packet({std::string("\x00\x03\x00", 3), bytesOf<float>({2.5F, 3.5F}), "", ""}));
    const Result<LoadedGeometry> read =
        readBack(craft.file(E57Craft::root(E57Craft::scan(at, 3, prototype))));
    ASSERT_TRUE(read) << read.error().sentence();
    ASSERT_EQ(read->geometry.vertices.size(), 3);
    EXPECT_EQ(read->geometry.vertices.point(0), Eigen::Vector3d(1 - 1000, 1.5, 7));
    EXPECT_EQ(read->geometry.vertices.point(1), Eigen::Vector3d(2 - 1000, 2.5, 7));
    EXPECT_EQ(read->geometry.vertices.point(2), Eigen::Vector3d(3 - 1000, 3.5, 7));
}

TEST(E57Hostile, CountsAndPlacesAreHeldAgainstTheFile) {
    E57Craft craft;
    const std::uint64_t at = craft.section(threePoints());
    const auto made = [&](std::uint64_t place, std::uint64_t records, const std::string& prototype,
                          const std::string& more = {}) {
        return craft.file(E57Craft::root(E57Craft::scan(place, records, prototype, more)));
    };
    ASSERT_TRUE(readBack(made(at, 3, kDoubles)));
    expectRefused(made(at, 4, kDoubles), "after 3 of 4 points");
    expectRefused(made(at, 1000000000000, kDoubles), "no room");
    expectRefused(made(at, 9223372036854775807, kDoubles), "no room");
    expectRefused(made(at + 4, 3, kDoubles), "another kind");
    expectRefused(made(1u << 30, 3, kDoubles), "outside of the file");
    expectRefused(made(1021, 3, kDoubles), "checksum");
    expectRefused(made(at, 3, kDoubles + "<intensity type=\"Float\"/>"), "3 byte streams");
    expectRefused(made(at, 3, "<cartesianX type=\"Float\"/>"), "no coordinates");
    expectRefused(made(at, 3, kDoubles + "<intensity type=\"String\"/>"), "text");
    expectRefused(made(at, 3, kDoubles + "<intensity type=\"Blob\"/>"), "cannot have");
    expectRefused(made(at, 3, kDoubles + "<rowIndex type=\"Integer\" minimum=\"3\" maximum=\"2\"/>"),
                  "above");
    expectRefused(made(at, 3, kDoubles + "<intensity type=\"ScaledInteger\" scale=\"1e300\" offset=\"0\"/>"),
                  "usable");
    expectRefused(made(at, 3, kDoubles + "<intensity type=\"ScaledInteger\" scale=\"nan\"/>"), "finite");
    expectRefused(made(at, 3, kDoubles, "<pose type=\"Structure\"><rotation/></pose>"), "quaternion");
    const std::string constant =
        "<cartesianX type=\"Integer\" minimum=\"1\" maximum=\"1\"/><cartesianY type=\"Integer\" "
        "minimum=\"1\" "
        "maximum=\"1\"/><cartesianZ type=\"Integer\" minimum=\"1\" maximum=\"1\"/>";
    expectRefused(made(at, 100000000, constant), "no room");
    // Scans that share one section would multiply it.
    E57Craft large;
    const std::string values(8000, '\0');
    const std::uint64_t shared = large.section(E57Craft::packet({values, values, values}));
    const std::string scan = E57Craft::scan(shared, 1000, kDoubles);
    EXPECT_TRUE(readBack(large.file(E57Craft::root(scan))));
    expectRefused(large.file(E57Craft::root(scan + scan)), "no room");
}

TEST(E57Hostile, ScansThatShareBytesAreRefused) {
    // There is room for the points of both, which lie behind 60000 bytes that every walk passes.
    const std::string ignored = std::string("\2\0\x5f\xea", 4) + std::string(59996, '\0');
    E57Craft craft;
    const std::uint64_t at = craft.section(ignored + threePoints());
    const std::string scan = E57Craft::scan(at, 3, kDoubles);
    EXPECT_TRUE(readBack(craft.file(E57Craft::root(scan))));
    expectRefused(craft.file(E57Craft::root(scan + scan)), "the same section");
    const std::string none = E57Craft::scan(at, 0, kDoubles);
    EXPECT_TRUE(readBack(craft.file(E57Craft::root(scan + none + none)))) << "they take nothing";
    // The header of a second section inside the first one, in its first packet; both end where that does.
    E57Craft nested;
    const std::string rest = ignored + threePoints();
    const std::uint64_t inner = nested.content.size() + 32 + 4;
    const std::string header =
        std::string("\1\0\0\0\0\0\0\0", 8) + bytesOf<std::uint64_t>({32 + rest.size(), inner + 32, 0});
    const std::uint64_t outer = nested.section(std::string("\2\0\x23\0", 4) + header + rest);
    const std::string first = E57Craft::scan(outer, 3, kDoubles), second = E57Craft::scan(inner, 3, kDoubles);
    EXPECT_TRUE(readBack(nested.file(E57Craft::root(first))));
    EXPECT_TRUE(readBack(nested.file(E57Craft::root(second))));
    expectRefused(nested.file(E57Craft::root(first + second)), "they share them");
}

TEST(E57Hostile, PacketsAreHeldAgainstTheirSection) {
    const auto made = [](const std::string& packets) {
        E57Craft craft;
        const std::uint64_t at = craft.section(packets);
        return craft.file(E57Craft::root(E57Craft::scan(at, 3, kDoubles)));
    };
    const auto with = [](std::size_t place, const std::string& bytes) {
        std::string packet = threePoints();
        return packet.replace(place, bytes.size(), bytes);
    };
    expectRefused(made(with(0, "\x07")), "unknown kind 7");
    expectRefused(made(with(2, "\xff\xff")), "does not fit");
    expectRefused(made(with(2, "\x04")), "does not fit");
    expectRefused(made(with(2, std::string("\x03\0", 2))), "too short");
    expectRefused(made(with(6, "\xff\xff")), "longer than it");
    expectRefused(made({}), "after 0 of 3");
    const std::string ignored = std::string("\2\0\7\0", 4) + "1234";
    EXPECT_TRUE(readBack(made(ignored + threePoints())));
    EXPECT_TRUE(readBack(made(E57Craft::packet({"", "", ""}) + threePoints())));
}

TEST(E57Hostile, XmlThatIsNoneOrABomb) {
    const auto made = [](const std::string& xml) { return E57Craft().file(xml); };
    expectRefused(made("<e57Root><data3D></e57Root>"), "cannot be parsed");
    expectRefused(made("<html/>"), "no root");
    expectRefused(made(E57Craft::root("<vectorChild/>")), "no points");
    const std::string entities =
        "<!DOCTYPE e57Root [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">"
        "<!ENTITY x SYSTEM \"file:///etc/hostname\">]>";
    const Result<LoadedGeometry> bomb = readBack(made(
        entities + E57Craft::root("", "<coordinateMetadata type=\"String\">&b;&x;</coordinateMetadata>")));
    ASSERT_TRUE(bomb) << bomb.error().sentence();
    EXPECT_EQ(bomb->info.crs, "&b;&x;");
    std::string deep;
    for (int i = 0; i < 200000; ++i) deep += "<a type=\"Structure\">";
    std::string closed = deep;
    for (int i = 0; i < 200000; ++i) closed += "</a>";
    expectRefused(made(deep), "cannot be parsed");
    expectRefused(made(E57Craft::root(E57Craft::scan(48, 1, closed))), "nested");
    EXPECT_TRUE(readBack(made(E57Craft::root("", closed))));
}

TEST(E57Hostile, CoordinatesThatAreNoneAreLeftOut) {
    E57Craft craft;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::uint64_t at = craft.section(E57Craft::packet(
        {bytesOf<double>({1, none, 3}), bytesOf<double>({10, 20, -1 / 0.0}), bytesOf<double>({1, 2, 3})}));
    const Result<LoadedGeometry> read = readBack(craft.file(E57Craft::root(E57Craft::scan(at, 3, kDoubles))));
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->geometry.vertices.size(), 1);
    ASSERT_EQ(read->info.warnings.size(), 1);
    EXPECT_NE(read->info.warnings[0].find("2 points without finite"), std::string::npos);
}

TEST(E57Hostile, ImagesAreHeldAgainstTheirSections) {
    const auto made = [](std::uint64_t length, std::uint64_t shift, const std::string& width) {
        E57Craft craft;
        const std::uint64_t at = craft.blob("not really a picture") + shift;
        return craft.file(E57Craft::root(
            "",
            "<images2D type=\"Vector\"><vectorChild type=\"Structure\"><name type=\"String\">pan</name>"
            "<sphericalRepresentation type=\"Structure\"><pngImage type=\"Blob\" fileOffset=\"" +
                std::to_string(at) + "\" length=\"" + std::to_string(length) +
                "\"/><imageWidth type=\"Integer\">" + width +
                "</imageWidth><imageHeight type=\"Integer\">50</imageHeight></sphericalRepresentation>"
                "</vectorChild></images2D>"));
    };
    const Result<LoadedGeometry> read = readBack(made(20, 0, "100"));
    ASSERT_TRUE(read) << read.error().sentence();
    ASSERT_EQ(read->info.images.size(), 1);
    EXPECT_EQ(read->info.images[0].projection, "spherical");
    EXPECT_EQ(read->info.images[0].format, "png");
    EXPECT_EQ(read->info.images[0].width, 100);
    EXPECT_FALSE(read->info.images[0].fileFromImage);
    expectRefused(made(21, 0, "100"), "another kind or length");
    expectRefused(made(1u << 30, 0, "100"), "beyond the file");
    expectRefused(made(20, 16, "100"), "another kind or length");
    expectRefused(made(20, 0, "-1"), "imageWidth");
}

TEST(E57Hostile, EveryWrongByteIsFound) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGeometry(folder / "whole.e57", {fullCloud(400, true), {}}));
    const std::string whole = readBytes(folder / "whole.e57");
    for (std::size_t at = 0; at < whole.size(); at += 97) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        const Result<LoadedGeometry> read = readBack(damaged);
        ASSERT_FALSE(read) << at;
        if (at >= 48) {
            EXPECT_NE(read.error().place.find("byte " + std::to_string(at / 1024 * 1024)), std::string::npos)
                << at << ": " << read.error().sentence();
        }
    }
}

TEST(E57Hostile, WhatIsWholeOfADamagedScanIsRead) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/e57/reference/bunnyDouble.e57");
    const LoadedGeometry whole = readOrFail(file);
    std::string bytes = readBytes(file);
    bytes[400000] = static_cast<char>(bytes[400000] ^ 1);
    expectRefused(bytes, "checksum");
    const Result<LoadedGeometry> refused = readBack(bytes, {});
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().salvageable) << "the window offers it";
    ReadOptions salvage;
    salvage.salvage = true;
    const Result<LoadedGeometry> read = readBack(bytes, salvage);
    ASSERT_TRUE(read) << read.error().sentence();
    const PointCloud& cloud = read->geometry.vertices;
    EXPECT_NE(refused.error().sentence().find(std::to_string(cloud.size()) + " points"), std::string::npos)
        << refused.error().sentence();
    ASSERT_GT(cloud.size(), 10000);
    ASSERT_LT(cloud.size(), whole.geometry.vertices.size());
    EXPECT_NE(read->info.damage.find(std::to_string(cloud.size()) + " of 30571 points"), std::string::npos)
        << read->info.damage;
    for (std::size_t i = 0; i < cloud.size(); ++i)
        ASSERT_EQ(cloud.point(i), whole.geometry.vertices.point(i));
    const Result<LoadedGeometry> again = readBack(readBytes(file), salvage);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->info.damage.empty());
    EXPECT_EQ(again->geometry.vertices.size(), 30571);
}

TEST(E57Hostile, DamageBesideThePointsIsToldToo) {
    E57Craft craft;
    const std::uint64_t at = craft.section(threePoints());
    craft.blob(std::string(3000, 'x'));
    std::string bytes = craft.file(E57Craft::root(E57Craft::scan(at, 3, kDoubles)));
    ReadOptions salvage;
    salvage.salvage = true;
    ASSERT_TRUE(readBack(bytes, salvage));
    EXPECT_TRUE(readBack(bytes, salvage)->info.damage.empty());
    bytes[1500] = 'y';
    expectRefused(bytes, "checksum");
    const Result<LoadedGeometry> read = readBack(bytes, salvage);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->geometry.vertices.size(), 3);
    EXPECT_NE(read->info.damage.find("1 page of 4 is damaged, the first at byte 1024; all points"),
              std::string::npos)
        << read->info.damage;
}

TEST(E57Hostile, ATruncatedFileIsRefusedWithWhatIsMissing) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/e57/reference/bunnyInt32.e57");
    const std::string bytes = readBytes(file);
    for (const std::size_t length : {47UL, 1000UL, 1024UL, 200000UL, bytes.size() - 1}) {
        expectRefused(bytes.substr(0, length), "end");
        ReadOptions salvage;
        salvage.salvage = true;
        const Result<LoadedGeometry> read = readBack(bytes.substr(0, length), salvage);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, ErrorCode::input);
    }
    const Result<LoadedGeometry> longer = readBack(bytes + std::string(500, 'x'));
    ASSERT_TRUE(longer);
    EXPECT_EQ(longer->info.warnings.size(), 1);
}

TEST(E57Hostile, PartsOfAFileAreTheSameAsPartsOfTheWhole) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/e57/reference/bunnyDouble.e57");
    const PointCloud whole = readOrFail(file).geometry.vertices;
    ReadOptions options;
    options.box = BoundingBox{{-0.05, 0.05, -0.03}, {0.02, 0.15, 0.03}};
    options.keepEvery = 7;
    const Result<LoadedGeometry> part = readGeometry(file, options);
    ASSERT_TRUE(part);
    std::vector<std::uint32_t> kept;
    std::size_t met = 0;
    for (std::uint32_t i = 0; i < whole.size(); ++i) {
        const Eigen::Vector3d point = whole.point(i);
        if ((point.array() >= options.box->min.array()).all() &&
            (point.array() <= options.box->max.array()).all() && met++ % 7 == 0)
            kept.push_back(i);
    }
    ASSERT_GT(kept.size(), 100);
    EXPECT_EQ(largestDifference(whole.select(kept), part->geometry.vertices), 0);
}

TEST(E57Hostile, APeekAndAPreviewTellWhatReadingFinds) {
    VESTIGE_SHARED_OR_SKIP(file, "formats/e57/reference/bunnyDouble.e57");
    const PointCloud whole = readOrFail(file).geometry.vertices;
    const Result<FileInfo> peeked = peekFile(file);
    ASSERT_TRUE(peeked);
    EXPECT_EQ(peeked->points, 30571);
    EXPECT_LT((peeked->bounds.max - whole.bounds().max).norm(), 1e-6);
    const FileFormat* format = *formatOfFile(file);
    const Result<std::optional<LoadedGeometry>> preview = format->preview(file, 3000, {});
    ASSERT_TRUE(preview && *preview);
    const PointCloud& some = (*preview)->geometry.vertices;
    EXPECT_GT(some.size(), 2500);
    EXPECT_LE(some.size(), 3100);
    // Runs of 64 from the beginning of strides of 64 * 11.
    for (std::size_t i = 0; i < some.size(); ++i)
        ASSERT_EQ(some.point(i), whole.point(i / 64 * 704 + i % 64));
    const Result<std::optional<LoadedGeometry>> all = format->preview(file, 40000, {});
    ASSERT_TRUE(all);
    EXPECT_FALSE(*all);
}
