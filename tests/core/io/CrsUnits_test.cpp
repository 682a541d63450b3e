#include "core/io/CrsUnits.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/io/WktTree.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

constexpr double kUsFoot = 1200.0 / 3937.0;

CrsRecord keysRecord(const std::vector<std::uint16_t>& keys) {
    CrsRecord record{"LASF_Projection", 34735, "", {}, false};
    std::vector<std::uint16_t> words{1, 1, 0, static_cast<std::uint16_t>(keys.size() / 4)};
    words.insert(words.end(), keys.begin(), keys.end());
    for (const std::uint16_t word : words) {
        record.bytes.push_back(static_cast<std::uint8_t>(word & 255));
        record.bytes.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    return record;
}

bool warnsOf(const FileInfo& info, const std::string& words) {
    return std::any_of(info.warnings.begin(), info.warnings.end(),
                       [&](const auto& warning) { return warning.find(words) != std::string::npos; });
}

}  // namespace

TEST(CrsUnits, RealLasFilesSayTheirUnit) {
    for (const char* name : {"autzen_trim.las", "autzen_trim.laz", "autzen_trim_7.las"}) {
        VESTIGE_SHARED_OR_SKIP(file, std::string("aerial/las/") + name);
        const LoadedGeometry autzen = readOrFail(file);
        ASSERT_TRUE(autzen.info.metresPerUnit) << name;
        EXPECT_EQ(lengthUnitOf(*autzen.info.metresPerUnit), LengthUnit::foot) << name;
    }
    VESTIGE_SHARED_OR_SKIP(nebraska, "aerial/las/laspy/file_with_both_wkt_and_geotiff_vlrs.las");
    EXPECT_EQ(lengthUnitOf(fileInfo(nebraska)->metresPerUnit.value_or(0)), LengthUnit::usSurveyFoot);
    VESTIGE_SHARED_OR_SKIP(degrees, "aerial/las/laspy/simple1_4.las");
    const auto geographic = fileInfo(degrees);
    EXPECT_FALSE(geographic->metresPerUnit);
    EXPECT_TRUE(warnsOf(*geographic, "degrees"));
    VESTIGE_SHARED_OR_SKIP(mixed, "aerial/las/autzen-bmx-2023.las");
    const auto metresAndFeet = fileInfo(mixed);
    EXPECT_EQ(metresAndFeet->metresPerUnit, 1);
    EXPECT_TRUE(warnsOf(*metresAndFeet, "heights are in US survey feet, the positions in metres"));
}

TEST(CrsUnits, KeysAloneSayTheSameAsWkt) {
    VESTIGE_SHARED_OR_SKIP(file, "aerial/las/autzen_trim.las");
    FileInfo info = *fileInfo(file);
    std::erase_if(info.crsRecords, [](const CrsRecord& record) { return record.recordId == 2112; });
    EXPECT_EQ(unitsOfRecords(info.crsRecords).horizontal, 0.3048);
}

TEST(CrsUnits, ReadsWktOfBothVersions) {
    EXPECT_EQ(unitsOfWkt("PROJCS[\"a\",GEOGCS[\"b\",UNIT[\"degree\",0.017]],UNIT[\"metre\",1]]").horizontal,
              1);
    const CrsUnits compound = unitsOfWkt(
        "COMPOUNDCRS[\"c\",\n PROJCRS[\"p\",BASEGEOGCRS[\"g\",ELLIPSOID[\"e\",6378137,298.25,"
        "LENGTHUNIT[\"metre\",1]]],CONVERSION[\"UTM\"],CS[Cartesian,2],AXIS[\"(E)\",east,ORDER[1],"
        "LENGTHUNIT[\"US survey foot\",0.304800609601219]]],\n VERTCRS[\"v\",CS[vertical,1],"
        "AXIS[\"up\",up],LENGTHUNIT[\"foot\",0.3048]]]");
    EXPECT_NEAR(compound.horizontal.value_or(0), kUsFoot, 1e-12);
    EXPECT_EQ(compound.vertical, 0.3048);
    const CrsUnits geocentric =
        unitsOfWkt("GEODCRS[\"WGS 84\",DATUM[\"d\"],CS[Cartesian,3],LENGTHUNIT[\"metre\",1.0]]");
    EXPECT_EQ(geocentric.horizontal, 1);
    EXPECT_FALSE(geocentric.degrees);
    EXPECT_TRUE(unitsOfWkt("GEOGCRS[\"WGS 84\",CS[ellipsoidal,2],ANGLEUNIT[\"degree\",0.017]]").degrees);
    EXPECT_EQ(unitsOfWkt("BOUNDCRS[SOURCECRS[PROJCRS[\"p\",LENGTHUNIT[\"foot\",0.3048]]],TARGETCRS[GEOGCRS["
                         "\"g\",CS[ellipsoidal,2]]]]")
                  .horizontal,
              0.3048);
}

TEST(CrsUnits, KnowsGeoTiffUnits) {
    EXPECT_EQ(unitsOfRecords({keysRecord({1024, 0, 1, 1, 3076, 0, 1, 9003})}).horizontal, kUsFoot);
    EXPECT_EQ(unitsOfRecords({keysRecord({3072, 0, 1, 32632})}).horizontal, 1);
    EXPECT_FALSE(unitsOfRecords({keysRecord({3072, 0, 1, 2994})}).horizontal);
    const CrsUnits both = unitsOfRecords({keysRecord({3076, 0, 1, 9001, 4099, 0, 1, 9002})});
    EXPECT_EQ(both.vertical, 0.3048);
    CrsRecord doubles{"LASF_Projection", 34736, "", std::vector<std::uint8_t>(8), false};
    const double size = 0.5;
    std::memcpy(doubles.bytes.data(), &size, 8);
    EXPECT_EQ(unitsOfRecords({keysRecord({3076, 0, 1, 32767, 3077, 34736, 1, 0}), doubles}).horizontal, 0.5);
    EXPECT_FALSE(unitsOfRecords({keysRecord({3076, 0, 1, 32767, 3077, 34736, 1, 9}), doubles}).horizontal);
}

TEST(CrsUnits, BrokenTextSaysNothing) {
    for (const char* text : {"", "PROJCS", "PROJCS[", "PROJCS[\"a", "PROJCS[\"a\",UNIT[\"x\",-1]]",
                             "PROJCS[\"a\",UNIT[\"x\",nan]]", "PROJCS[\"a\",UNIT[\"x\"]]", "PROJCS[,]",
                             "PROJCS[\"a\",UNIT[\"m\",1]", "EPSG:25832"})
        EXPECT_FALSE(unitsOfWkt(text).horizontal) << text;
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "A[";
    EXPECT_FALSE(parseWkt(deep));
    CrsRecord odd = keysRecord({3076, 0, 1, 9002});
    odd.bytes.resize(odd.bytes.size() - 1);
    EXPECT_FALSE(unitsOfRecords({odd}).horizontal);
}

TEST(Units, AreExactAndToldApart) {
    for (const LengthUnit unit : kLengthUnits) {
        EXPECT_EQ(lengthUnitFromSymbol(symbol(unit)), unit);
        EXPECT_EQ(lengthUnitOf(metresPer(unit)), unit);
    }
    EXPECT_EQ(lengthUnitOf(0.3048006096), LengthUnit::usSurveyFoot);
    EXPECT_EQ(lengthUnitOf(0.3048), LengthUnit::foot);
    EXPECT_FALSE(lengthUnitOf(0.3047972654));
    EXPECT_FALSE(lengthUnitOf(0));
    EXPECT_EQ(nearestLengthUnit(0.0009), LengthUnit::millimetre);
    EXPECT_EQ(nearestLengthUnit(0.3048), LengthUnit::foot);
    EXPECT_EQ(lengthUnitFromSymbol("yd"), std::nullopt);
}
