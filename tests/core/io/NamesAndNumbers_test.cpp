#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <cstring>
#include <locale>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/DecimalComma.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// Of every format that can be written.
std::vector<std::string> writable() {
    std::vector<std::string> extensions;
    for (const auto& format : fileFormats())
        if (format->canWrite())
            for (std::string& extension : format->extensions()) extensions.push_back(std::move(extension));
    return extensions;
}

/// The largest distance of a point to the nearest of the others, for formats that order points anew.
double largestGap(const PointCloud& from, const PointCloud& to) {
    if (from.size() != to.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < to.size(); ++k)
            nearest = std::min(nearest, (from.point(i) - to.point(k)).cwiseAbs().maxCoeff());
        largest = std::max(largest, nearest);
    }
    return largest;
}

void expectThereAndBack(const std::filesystem::path& file, const PointCloud& cloud, double tolerance,
                        const FileInfo* source = nullptr) {
    const Status written = writeGeometry(file, {cloud, {}}, {source});
    ASSERT_TRUE(written) << written.error().sentence();
    const PointCloud back = readOrFail(file).geometry.vertices;
    const std::string extension = file.extension().string();
    // glTF cuts wide clouds into cells.
    const bool cut = (extension == ".glb" || extension == ".gltf") && cloud.bounds().diagonal() > 1024;
    EXPECT_LT(cut ? largestGap(cloud, back) : largestDifference(cloud, back), tolerance) << file;
    if (cut) {
        EXPECT_LT(largestGap(back, cloud), tolerance) << file;
    }
}

/// A block of the size, its points anywhere in it.
PointCloud block(const Eigen::Vector3d& corner, double size) {
    Random random(23);
    PointCloudBuilder builder;
    for (int i = 0; i < 500; ++i)
        builder.add(corner + size * Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform()));
    return std::move(builder).build();
}

FileInfo inUsSurveyFeet() {
    const std::string wkt =
        "PROJCS[\"NAD83 / Ohio South (ftUS)\",GEOGCS[\"NAD83\",UNIT[\"degree\",0.0174532925199433]],"
        "UNIT[\"US survey foot\",0.304800609601219,AUTHORITY[\"EPSG\",\"9003\"]]]";
    FileInfo info;
    info.crsRecords = {{"LASF_Projection", 2112, "OGC WKT", {wkt.begin(), wkt.end()}, false}};
    info.crsRecords[0].bytes.push_back(0);
    return info;
}

}  // namespace

TEST(Names, OfAnyScriptReadAndWrite) {
    const TemporaryFolder folder;
    const PointCloud cloud = fullCloud(50, true);
    // Composed and decomposed letters, other scripts, an emoji, blanks and quotes, and bytes that are no
    // UTF-8.
    for (const std::string name :
         {"Straße Zürich",
          "u\xcc\x88"
          "ber",
          "現場測量", "Вид сверху", "\xf0\x9f\x9a\x97 'a' \"b\"", "caf\xe9", "a,b;c#d%e", "line\nbreak"}) {
        std::filesystem::create_directories(folder / name);
        for (const std::string& extension : writable())
            expectThereAndBack(folder / name / (name + "." + extension), cloud, 1e-4);
    }
}

TEST(Names, LongPathsAndTheLongestNames) {
    const TemporaryFolder folder;
    const PointCloud cloud = fullCloud(50, true);
    for (const std::string& extension : writable()) {
        std::filesystem::path deep = folder.path();
        while (deep.string().size() < 200) deep /= "a folder of 32 letters, or so it";
        expectThereAndBack(deep / ("cloud." + extension), cloud, 1e-4);
        for (const std::string letter : {"x", "ä", "測"}) {
            const std::size_t letters = (255 - 1 - extension.size()) / letter.size();
            std::string name;
            for (std::size_t i = 0; i < letters; ++i) name += letter;
            const auto longest = folder / (name + "." + extension);
            expectThereAndBack(longest, cloud, 1e-4);
            expectThereAndBack(longest, cloud, 1e-4);  // once more, over what stands there
        }
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 4)
            << "nothing is left beside them";
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            std::filesystem::remove_all(entry);
    }
    const Status tooLong = writeGeometry(folder / (std::string(252, 'x') + ".ply"), {cloud, {}});
    ASSERT_FALSE(tooLong);
    EXPECT_EQ(tooLong.error().code, ErrorCode::output);
}

TEST(Numbers, UtmAndEarthCentredCoordinatesThroughEveryFormat) {
    const TemporaryFolder folder;
    const Eigen::Vector3d kCorners[] = {{576661.1234, 5188114.5678, 156.0912},         // UTM
                                        {500000, 9999999.4321, -12.5},                 // UTM south
                                        {-2701234.5678, -4290123.4567, 3855678.9012},  // ECEF
                                        {6378137.0001, 0.0002, -0.0003}};
    for (const std::string& extension : writable())
        for (const Eigen::Vector3d& corner : kCorners)
            for (const double size : {0.5, 300.0, 100000.0})
                expectThereAndBack(folder / ("cloud." + extension), block(corner, size), 1e-4);
}

TEST(Numbers, FeetAndMillimetresStayWhatTheyAre) {
    const TemporaryFolder folder;
    const FileInfo feet = inUsSurveyFeet();
    const PointCloud inFeet = block({1892345.6789, 643210.9876, 712.3456}, 2000);
    // The site in millimetres, far larger numbers than any scan has.
    const PointCloud inMillimetres = block({-1234567.5, 2345678.25, 98765.125}, 50000);
    for (const std::string& extension : writable()) {
        expectThereAndBack(folder / ("feet." + extension), inFeet, 1e-4, &feet);
        expectThereAndBack(folder / ("mm." + extension), inMillimetres, 1e-4);
    }
    for (const char* name : {"feet.las", "feet.laz"}) {
        const LoadedGeometry back = readOrFail(folder / name);
        ASSERT_TRUE(back.info.metresPerUnit) << name;
        EXPECT_EQ(lengthUnitOf(*back.info.metresPerUnit), LengthUnit::usSurveyFoot) << name;
    }
}

TEST(Numbers, ADecimalCommaChangesNothing) {
    const TemporaryFolder folder;
    const TriangleMesh mesh{fullCloud(200, false), {}};
    const FileInfo feet = inUsSurveyFeet();
    const auto write = [&](const std::string& name) {
        for (const std::string& extension : writable())
            EXPECT_TRUE(writeGeometry(folder / (name + "." + extension), mesh, {&feet})) << extension;
    };
    write("point");
    writeBytes(folder / "a.obj", "v 1.5 2.25 -3.125\nv 1e1 0.5 0\nv 0 1.5 0\nf 1 2 3\n");
    writeBytes(
        folder / "a.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1.5 2.25 -3.125\nvertex 10 0.5 0\nvertex 0 1.5 0\n"
        "endloop\nendfacet\nendsolid a\n");
    writeBytes(folder / "a.vtk",
               "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 double\n1.5 2.25 -3.125\n");
    writeBytes(folder / "a.pcd",
               "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 1\nDATA ascii\n1.5 "
               "2.25 -3.125\n");
    writeBytes(folder / "a.ply",
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
               "property double z\nend_header\n1.5 2.25 -3.125\n");
    writeBytes(folder / "a.ptx",
               "1\n1\n0 0 0.5\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0.5 1\n"
               "1.5 2.25 -3.625 0.5\n");
    const DecimalComma comma;
    if (!comma.works()) GTEST_SKIP() << "skipped: there is no localedef to make a decimal comma with";
    write("comma");
    for (const std::string& extension : writable()) {
        EXPECT_EQ(readBytes(folder / ("point." + extension)), readBytes(folder / ("comma." + extension)))
            << extension;
        EXPECT_LT(
            largestDifference(mesh.vertices, readOrFail(folder / ("comma." + extension)).geometry.vertices),
            1e-4)
            << extension;
    }
    for (const char* name : {"a.obj", "a.stl", "a.vtk", "a.pcd", "a.ply", "a.ptx"})
        EXPECT_EQ(readOrFail(folder / name).geometry.vertices.point(0), Eigen::Vector3d(1.5, 2.25, -3.125))
            << name;
    EXPECT_EQ(lengthUnitOf(readOrFail(folder / "comma.las").info.metresPerUnit.value_or(0)),
              LengthUnit::usSurveyFoot);
}
