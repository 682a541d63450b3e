#include <gtest/gtest.h>

#include "tests/core/io/Clouds.h"
#include "tests/core/io/E57Craft.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// Two points whose records have these fields beside coordinates of 8 bits.
PointAttributes attributesOf(const std::string& fields, std::vector<std::string> streams,
                             const std::string& more = {}) {
    E57Craft craft;
    const std::string axis = " type=\"Integer\" minimum=\"0\" maximum=\"255\"/>";
    streams.insert(streams.begin(), 3, std::string("\1\2"));
    const std::uint64_t at = craft.section(E57Craft::packet(streams));
    const TemporaryFolder folder;
    writeBytes(
        folder / "a.e57",
        craft.file(E57Craft::root(E57Craft::scan(
            at, 2, "<cartesianX" + axis + "<cartesianY" + axis + "<cartesianZ" + axis + fields, more))));
    const LoadedGeometry loaded = readOrFail(folder / "a.e57");
    EXPECT_EQ(loaded.geometry.vertices.size(), 2);
    return loaded.geometry.vertices.attributes();
}

std::string colors(const std::string& type) {
    return "<colorRed" + type + "<colorGreen" + type + "<colorBlue" + type;
}

std::vector<std::string> threeTimes(const std::string& stream) {
    return {stream, stream, stream};
}

}  // namespace

TEST(E57Values, ScaledIntegersAreRounded) {
    const std::string field =
        " type=\"ScaledInteger\" minimum=\"0\" maximum=\"255\" scale=\"0.29999\" offset=\"0\"/>";
    // 0.29999 times 10 and 21: 2.9999 and 6.29979.
    const PointAttributes found =
        attributesOf("<las:classification" + field + "<las:pointSourceId" + field, {"\12\25", "\12\25"});
    ASSERT_EQ(found.classification.size(), 2);
    EXPECT_EQ(found.classification[0], 3);
    EXPECT_EQ(found.classification[1], 6);
    ASSERT_EQ(found.pointSource.size(), 2);
    EXPECT_EQ(found.pointSource[0], 3);
    EXPECT_EQ(found.pointSource[1], 6);
}

TEST(E57Values, FloatsThatAreNoNumbersAreNoClass) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const PointAttributes found =
        attributesOf("<classification type=\"Float\" precision=\"single\"/>", {bytesOf<float>({none, 1e9F})});
    ASSERT_EQ(found.classification.size(), 2);
    EXPECT_EQ(found.classification[0], 0);
    EXPECT_EQ(found.classification[1], 255);
}

TEST(E57Values, AConstantColourIsWhatItSays) {
    const auto constant = [](const std::string& value) {
        const PointAttributes found =
            attributesOf(colors(" type=\"Integer\" minimum=\"" + value + "\" maximum=\"" + value + "\"/>"),
                         threeTimes(""));
        EXPECT_EQ(found.color.size(), 2) << value;
        return found.color.size() == 2 ? found.color[1] : Color{1, 1, 1};
    };
    EXPECT_EQ(constant("0"), (Color{0, 0, 0}));
    EXPECT_EQ(constant("51"), (Color{51 * 257, 51 * 257, 51 * 257}));
    EXPECT_EQ(constant("255"), (Color{65535, 65535, 65535}));
    EXPECT_EQ(constant("1000"), (Color{1000, 1000, 1000}));
}

TEST(E57Values, InfiniteLimitsOfFloatsSayNothing) {
    const std::string wide = " type=\"Float\" precision=\"single\" minimum=\"-inf\" maximum=\"INF\"/>";
    const PointAttributes found = attributesOf(
        "<intensity" + wide + colors(wide),
        {bytesOf<float>({7, 8}), bytesOf<float>({0, 1}), bytesOf<float>({0.5F, 1}), bytesOf<float>({0, 0})});
    ASSERT_EQ(found.intensity.size(), 2);
    EXPECT_EQ(found.intensity[1], 8);
    ASSERT_EQ(found.color.size(), 2);
    EXPECT_EQ(found.color[1], (Color{65535, 65535, 0}));
}

TEST(E57Values, IntensitiesBeyondAFloatAreItsLargest) {
    const PointAttributes found =
        attributesOf("<intensity type=\"Float\"/>", {bytesOf<double>({1e300, -1e300})});
    ASSERT_EQ(found.intensity.size(), 2);
    EXPECT_EQ(found.intensity[0], std::numeric_limits<float>::max());
    EXPECT_EQ(found.intensity[1], std::numeric_limits<float>::lowest());
}
