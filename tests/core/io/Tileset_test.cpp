#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/io/LooksLikeTileset.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/TileFiles.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// A tile of one point (x, 0, 0).
std::string pointAt(float x) {
    return pntsOf({{x, 0, 0}});
}

std::vector<double> xOf(const PointCloud& cloud) {
    std::vector<double> list;
    for (std::size_t i = 0; i < cloud.size(); ++i) list.push_back(cloud.point(i).x());
    return list;
}

std::vector<double> xOf(const std::filesystem::path& file) {
    return xOf(readOrFail(file).geometry.vertices);
}

bool contains(const std::vector<std::string>& list, const std::string& part) {
    for (const std::string& one : list)
        if (one.find(part) != std::string::npos) return true;
    return false;
}

const std::string kLevels = R"("content":{"uri":"1.pnts"},"children":[
    {"content":{"url":"2.pnts"},"children":[{"content":{"uri":"3.pnts"}}]},
    {"content":{"uri":"4.pnts"}},
    {"children":[{}],"contents":[{"uri":"5.pnts"},{"uri":"6.pnts"}]}])";

void writeLevels(const TemporaryFolder& folder) {
    for (int i = 1; i <= 6; ++i)
        writeBytes(folder / (std::to_string(i) + ".pnts"), pointAt(static_cast<float>(i)));
}

}  // namespace

TEST(Tileset, AddTakesAllLevelsAndReplaceTheFinest) {
    const TemporaryFolder folder;
    writeLevels(folder);
    writeBytes(folder / "add.json", tilesetJson(R"("refine":"ADD",)" + kLevels));
    EXPECT_EQ(xOf(folder / "add.json"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    writeBytes(folder / "replace.json", tilesetJson(R"("refine":"REPLACE",)" + kLevels));
    const LoadedGeometry finest = readOrFail(folder / "replace.json");
    // An empty child replaces nothing: 5 and 6 stay.
    EXPECT_EQ(xOf(finest.geometry.vertices), (std::vector<double>{3, 4, 5, 6}));
    EXPECT_TRUE(contains(finest.info.warnings, "2 coarser tiles left out"));
    EXPECT_EQ(finest.info.version, "1.0, 4 tiles");
    EXPECT_EQ(finest.info.metresPerUnit, 1.0);
    // A tile's own refinement counts for its children and below.
    writeBytes(folder / "mixed.json",
               tilesetJson(R"("refine":"add","content":{"uri":"1.pnts"},"children":[{"refine":"replace",
                   "content":{"uri":"2.pnts"},"children":[{"content":{"uri":"3.pnts"},
                   "children":[{"content":{"uri":"4.pnts"}}]}]}])"));
    EXPECT_EQ(xOf(folder / "mixed.json"), (std::vector<double>{1, 4}));
}

TEST(Tileset, ALocalCloudWithItsTransformIsTheEarthCentredOne) {
    VESTIGE_SHARED_OR_SKIP(local,
                           "formats/pnts/PointCloud/PointCloudWithTransform/pointCloudWithTransform.pnts");
    VESTIGE_SHARED_OR_SKIP(ecef, "formats/pnts/PointCloud/PointCloudRGB/pointCloudRGB.pnts");
    // Where the authors of the samples put them (their generator's longitude and latitude).
    const double longitude = -75.61209430782448, latitude = 40.042530611425896;
    const Eigen::Matrix4d place = eastNorthUp(longitude, latitude, 5);
    ASSERT_LT((place.topRightCorner<3, 1>() -
               Eigen::Vector3d(1215012.8828876738, -4736313.051199594, 4081605.22126042))
                  .norm(),
              1e-7);
    const TemporaryFolder folder;
    std::filesystem::copy_file(local, folder / "points.pnts");
    writeBytes(folder / "tileset.json",
               tilesetJson(transformJson(place) + R"(,"refine":"ADD","content":{"uri":"points.pnts"})"));
    const PointCloud here = readOrFail(folder / "tileset.json").geometry.vertices;
    const PointCloud reference = readOrFail(ecef).geometry.vertices;
    EXPECT_LT(largestDifference(here, reference), 2e-6);  // both are floats of up to 9 m
    expectSameAttributes(reference, here);
}

TEST(Tileset, TransformsAreChainedInDoubleDownToTheCentre) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "deep");
    const Eigen::Vector3d centre(12.3456789, -0.000123456, 987.654321);
    std::string numbers;
    for (int i = 0; i < 3; ++i) numbers += (i > 0 ? "," : "") + std::to_string(centre[i]);
    const Eigen::Vector3d written(12.345679, -0.000123, 987.654321);  // std::to_string has six decimals
    writeBytes(folder / "deep/points.pnts",
               pntsBytes(R"({"POINTS_LENGTH":2,"POSITION":{"byteOffset":0},"NORMAL":{"byteOffset":24},
                             "RTC_CENTER":[)" +
                             numbers + "]}",
                         bytesOf<float>({0, 0, 0, 100.5F, -7.25F, 0.125F, 0, 0, 1, 1, 0, 0})));
    const Eigen::Matrix4d place = eastNorthUp(11.5, 48.1, 520);
    Eigen::Affine3d turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
    turn.pretranslate(Eigen::Vector3d(250, -30, 4));
    Eigen::Affine3d squeeze(Eigen::Scaling(2.0, 1.0, 0.5));
    writeBytes(folder / "tileset.json",
               tilesetJson(R"("refine":"ADD",)" + transformJson(place) + R"(,"children":[{)" +
                           transformJson(turn.matrix()) + R"(,"content":{"uri":"deep/child.json"}}])"));
    writeBytes(folder / "deep/child.json",
               tilesetJson(R"("refine":"ADD",)" + transformJson(squeeze.matrix()) +
                           R"(,"content":{"uri":"points.pnts"})"));
    const PointCloud cloud = readOrFail(folder / "tileset.json").geometry.vertices;
    ASSERT_EQ(cloud.size(), 2);
    const Eigen::Matrix4d chain = place * turn.matrix() * squeeze.matrix();
    for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Vector3d offset =
            i == 0 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(100.5, -7.25, 0.125);
        const Eigen::Vector3d expected = (chain * (written + offset).homogeneous()).head<3>();
        EXPECT_LT((cloud.point(i) - expected).norm(), 1.6e-5);  // PointCloudBuilder::kExactRange
        // The inverse transpose: diag(1/2, 1, 2) before the turns.
        const Eigen::Vector3d normal = i == 0 ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(1, 0, 0);
        const Eigen::Vector3d turned = place.topLeftCorner<3, 3>() * (turn.linear() * normal);
        EXPECT_LT((cloud.attributes().normal[i].cast<double>() - turned).norm(), 1e-6);
    }
}

TEST(Tileset, NamesAreDecodedAndRelativeToTheTilesetThatHasThem) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "a b/\u00e4");
    writeBytes(folder / "a b/1.pnts", pointAt(1));
    writeBytes(folder / "a b/\u00e4/2.pnts", pointAt(2));
    writeBytes(folder / "a b/\u00e4/3.pnts", pointAt(3));
    writeBytes(folder / "4.pnts", pointAt(4));
    writeBytes(folder / "tileset.json",
               tilesetJson(R"("refine":"ADD","children":[{"content":{"uri":"a%20b/1.pnts?v=1.2#x"}},
                   {"content":{"uri":"./a%20b/%C3%A4/next.json"}}])"));
    writeBytes(folder / "a b/\u00e4/next.json",
               tilesetJson(R"("refine":"ADD","contents":[{"uri":"2.pnts"},{"uri":"..\\\u00e4\\3.pnts"},
                   {"uri":"../../4.pnts"}])"));
    EXPECT_EQ(xOf(folder / "tileset.json"), (std::vector<double>{1, 2, 3, 4}));
}

TEST(Tileset, OnlyRegionsMakeItEarthCentred) {
    const TemporaryFolder folder;
    writeBytes(folder / "a.pnts", pointAt(1));
    const auto crsOf = [&](const std::string& volume, const Eigen::Matrix4d& place) {
        writeBytes(folder / "tileset.json", tilesetJson(R"("refine":"ADD",)" + transformJson(place) + volume +
                                                        R"(,"content":{"uri":"a.pnts"})"));
        return readOrFail(folder / "tileset.json").info.crs;
    };
    const std::string region = R"(,"boundingVolume":{"region":[-1.3,0.69,-1.2,0.7,0,20]})";
    EXPECT_NE(crsOf(region, eastNorthUp(-74, 39.8, 30)).find("EPSG:4978"), std::string::npos);
    EXPECT_EQ(crsOf(R"(,"boundingVolume":{"sphere":[0,0,0,9]})", eastNorthUp(-74, 39.8, 30)), "");
    EXPECT_EQ(crsOf(region, Eigen::Matrix4d::Identity()), "");
}

TEST(Tileset, AttributesThatSomeTilesLackAreZeroThere) {
    const TemporaryFolder folder;
    writeBytes(folder / "1.pnts", pointAt(1));
    writeBytes(folder / "2.pnts",
               pntsBytes(R"({"POINTS_LENGTH":1,"POSITION":{"byteOffset":0},"CONSTANT_RGBA":[1,2,3,255]})",
                         bytesOf<float>({2, 0, 0}), R"({"intensity":[9],"other":[1]})"));
    writeBytes(folder / "3.pnts", pointAt(3));
    writeBytes(
        folder / "tileset.json",
        tilesetJson(R"("refine":"ADD","contents":[{"uri":"1.pnts"},{"uri":"2.pnts"},{"uri":"3.pnts"}])"));
    const LoadedGeometry loaded = readOrFail(folder / "tileset.json");
    const PointAttributes& attributes = loaded.geometry.vertices.attributes();
    ASSERT_EQ(attributes.intensity.size(), 3);
    EXPECT_EQ(attributes.intensity[0], 0);
    EXPECT_EQ(attributes.intensity[1], 9);
    EXPECT_EQ(attributes.intensity[2], 0);
    EXPECT_EQ(attributes.color, (LargeArray<Color>{{0, 0, 0}, {257, 514, 771}, {0, 0, 0}}));
    EXPECT_EQ(loaded.info.attributes, (std::vector<std::string>{"intensity", "color"}));
    EXPECT_TRUE(contains(loaded.info.warnings, "not all tiles have the same attributes"));
    EXPECT_TRUE(contains(loaded.info.warnings, "not kept: other"));

    ReadOptions options;
    options.keepEvery = 2;
    options.attributes = ReadOptions::Attributes::drawn;
    const auto part = readGeometry(folder / "tileset.json", options);
    ASSERT_TRUE(part);
    EXPECT_EQ(xOf(part->geometry.vertices), (std::vector<double>{1, 3}));
    const Result<FileInfo> peeked = peekFile(folder / "tileset.json");
    ASSERT_TRUE(peeked);
    EXPECT_EQ(peeked->points, 3);
    EXPECT_EQ(peeked->attributes, loaded.info.attributes);
    EXPECT_EQ(peeked->version, loaded.info.version);
}

TEST(Tileset, OtherContentsArePassedOverAndTold) {
    const TemporaryFolder folder;
    writeBytes(folder / "1.pnts", pointAt(1));
    writeBytes(folder / "a.b3dm", "b3dm and so on");
    writeBytes(folder / "b.b3dm", "b3dm and so on");
    writeBytes(folder / "c.gltf", R"({"asset":{"version":"2.0"}})");
    writeBytes(folder / "tileset.json",
               tilesetJson(R"("refine":"ADD","contents":[{"uri":"1.pnts"},{"uri":"a.b3dm"},{"uri":"b.b3dm"},
                              {"uri":"c.gltf"}])"));
    const LoadedGeometry loaded = readOrFail(folder / "tileset.json");
    EXPECT_EQ(loaded.info.points, 1);
    EXPECT_TRUE(contains(loaded.info.warnings, "2 tiles of the kind b3dm passed over"));
    EXPECT_TRUE(contains(loaded.info.warnings, "1 tile of the kind glTF passed over"));
}

TEST(Tileset, SalvageReadsTheTilesThatAreThere) {
    const TemporaryFolder folder;
    writeBytes(folder / "1.pnts", pointAt(1));
    writeBytes(folder / "2.pnts", pointAt(2).substr(0, 60));
    writeBytes(
        folder / "tileset.json",
        tilesetJson(
            R"("refine":"ADD","contents":[{"uri":"2.pnts"},{"uri":"missing.pnts"},{"uri":"1.pnts"}])"));
    EXPECT_FALSE(readGeometry(folder / "tileset.json"));
    ReadOptions options;
    options.salvage = true;
    const auto saved = readGeometry(folder / "tileset.json", options);
    ASSERT_TRUE(saved) << saved.error().sentence();
    EXPECT_EQ(xOf(saved->geometry.vertices), (std::vector<double>{1}));
    EXPECT_EQ(saved->info.damage.find("2 of the tiles could not be read whole"), 0) << saved->info.damage;
}

TEST(Tileset, IsRecognisedByItsKeysAlone) {
    const TemporaryFolder folder;
    writeBytes(folder / "1.pnts", pointAt(1));
    const std::string root = R"({"refine":"ADD","content":{"uri":"1.pnts"},"extras":")";
    const std::string late =
        R"({"root":)" + root + std::string(9000, 'x') + R"("},"asset":{"version":"1.1"}})";
    writeBytes(folder / "late.json", "\xef\xbb\xbf\n" + late);
    EXPECT_TRUE(looksLikeTileset(folder / "late.json"));
    EXPECT_EQ(xOf(folder / "late.json"), (std::vector<double>{1}));
    writeBytes(folder / "named.tiles", tilesetJson(R"("refine":"ADD","content":{"uri":"1.pnts"})"));
    EXPECT_EQ(xOf(folder / "named.tiles"), (std::vector<double>{1}));
    for (const char* other :
         {R"({"vestige":1,"asset":{},"root":{}})", R"({"layers":[{"asset":1,"root":2}]})", R"({"asset":{}})",
          R"(["asset","root"])", R"({"a":"\"asset\":","b":"root"})", "{", "", R"({"asset)"}) {
        writeBytes(folder / "other.json", other);
        EXPECT_FALSE(looksLikeTileset(folder / "other.json")) << other;
        EXPECT_FALSE(readGeometry(folder / "other.json")) << other;
    }
    EXPECT_FALSE(looksLikeTileset(folder / "none.json"));
    EXPECT_FALSE(looksLikeTileset(folder.path()));
}
