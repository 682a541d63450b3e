#include <gtest/gtest.h>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

LoadedGeometry readText(const std::string& name, const std::string& content) {
    const TemporaryFolder folder;
    writeBytes(folder / name, content);
    return readOrFail(folder / name);
}

Eigen::Vector3d first(const LoadedGeometry& loaded) {
    return loaded.geometry.vertices.empty() ? Eigen::Vector3d::Zero() : loaded.geometry.vertices.point(0);
}

}  // namespace

TEST(TextFormat, RecognisesColumnsByHeader) {
    const auto asl = readText("a.csv", "Time_in_sec,x,y,z,Intensities,2DscanId,PointId\n1.5,1,2,3,7,0,0\n");
    EXPECT_EQ(first(asl), Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(asl.geometry.vertices.attributes().gpsTime, std::vector<double>{1.5});
    EXPECT_EQ(asl.geometry.vertices.attributes().intensity, std::vector<float>{7});
    const auto quoted = readText("b.txt", "\"X\",\"Y\",\"Z\"\n0 1 2\n");
    EXPECT_EQ(first(quoted), Eigen::Vector3d(0, 1, 2));
    const auto compare = readText("c.asc", "//X Y Z R G B Nx Ny Nz\r\n1;2;3;255;0;1;0;0;1\r\n");
    EXPECT_EQ(compare.geometry.vertices.attributes().color, (LargeArray<Color>{{65535, 0, 257}}));
    EXPECT_EQ(compare.geometry.vertices.attributes().normal.size(), 1);
}

TEST(TextFormat, GuessesColumnsFromValues) {
    const auto has = [](const std::string& rows) { return readText("a.xyz", rows).info.version; };
    EXPECT_EQ(has("1 2 3\n"), "x y z");
    EXPECT_EQ(has("1 2 3 0.5\n4 5 6 -7\n"), "x y z intensity");
    EXPECT_EQ(has("1 2 3 255 0 12\n4 5 6 1 1 1\n"), "x y z red green blue");
    EXPECT_EQ(has("1 2 3 0 0 1\n4 5 6 0.6 0 -0.8\n"), "x y z nx ny nz");
    EXPECT_EQ(has("1 2 3 -400 255 0 12\n4 5 6 9 1 1 1\n"), "x y z intensity red green blue");
    EXPECT_EQ(has("1 2 3 255 0 12 0.25\n4 5 6 9 1 1 0.5\n"), "x y z red green blue intensity");
    EXPECT_EQ(has("1 2 3 9 8 200 0 0 1\n4 5 6 7 8 9 0 1 0\n"), "x y z red green blue nx ny nz");
}

TEST(PlyFormat, ReadsAnyLayout) {
    const auto ply =
        readText("a.ply",
                 "ply\r\nformat ascii 1.0\r\ncomment c\r\nobj_info i\r\nelement other 1\r\n"
                 "property list uchar int z\r\nelement vertex 5\r\nproperty int64 x\r\nproperty double y\r\n"
                 "property list uchar float skip\r\nproperty short z\r\nproperty float red\r\n"
                 "property float green\r\nproperty float blue\r\nelement face 1\r\n"
                 "property list uchar uchar vertex_index\r\nend_header\r\n"
                 "2 9 9\r\n0 0 1 5 0 1 .5 0\r\n4 0 0 0 1 0 0\r\n1 1 0 0 1 0 0\r\n0 4 0 0 1 0 0\r\n"
                 "7 7 0 0 0 0 0\r\n4 0 1 2 3\r\n");
    ASSERT_EQ(ply.geometry.vertices.size(), 5);
    EXPECT_EQ(ply.geometry.vertices.point(1), Eigen::Vector3d(4, 0, 0));
    EXPECT_EQ(ply.geometry.vertices.attributes().color[0], (Color{65535, 32768, 0}));
    // The face is concave at vertex 2: only the cut through that corner stays inside.
    ASSERT_EQ(ply.geometry.triangles.size(), 2);
    EXPECT_NEAR(surfaceArea(ply.geometry), 4, 1e-12);
}

TEST(PlyFormat, NumbersBeyondAFloatReadTheSameByRowsAndAtOnce) {
    const TemporaryFolder folder;
    const std::string properties =
        "element vertex 1\nproperty double x\nproperty double y\nproperty double z\nproperty double "
        "intensity\n"
        "property double nx\nproperty double ny\nproperty double nz\nend_header\n";
    const double values[] = {1, 2, 3, 1e300, 1e200, 0, 0};
    writeBytes(folder / "rows.ply", "ply\nformat ascii 1.0\n" + properties + "1 2 3 1e300 1e200 0 0\n");
    writeBytes(folder / "once.ply", "ply\nformat binary_little_endian 1.0\n" + properties +
                                        std::string(reinterpret_cast<const char*>(values), sizeof values));
    for (const char* name : {"rows.ply", "once.ply"}) {
        const PointCloud cloud = readOrFail(folder / name).geometry.vertices;
        ASSERT_EQ(cloud.size(), 1) << name;
        EXPECT_EQ(cloud.attributes().intensity[0], std::numeric_limits<float>::max()) << name;
        EXPECT_EQ(cloud.attributes().normal[0], Eigen::Vector3f::Zero()) << name;
    }
}

TEST(PcdFormat, ReadsPackedColoursAndLeavesHolesOut) {
    const std::string head =
        "FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 3\nHEIGHT 1\n"
        "VIEWPOINT 1 0 0 1 0 0 0\nDATA ascii\n";
    const auto pcd =
        readText("a.pcd", "VERSION .7\n" + head + "1 2 3 4.2108e+06\nnan nan nan 0\n4 5 6 2.3418052e-38\n");
    ASSERT_EQ(pcd.geometry.vertices.size(), 2);
    EXPECT_EQ(pcd.geometry.vertices.attributes().color[0], (Color{0x40 * 257, 0x40 * 257, 0x70 * 257}));
    EXPECT_EQ(pcd.geometry.vertices.attributes().color[1], (Color{0xff * 257, 0, 0}));
    EXPECT_EQ(pcd.info.warnings.size(), 2);
}

TEST(VtkFormat, ReadsBothVersionsOfPolygons) {
    const std::string head = "DATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n";
    const auto three =
        readText("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\n" + head +
                              "POLYGONS 1 5\n4 0 1 2 3\nCELL_DATA 1\nSCALARS i float\nLOOKUP_TABLE d\n1\n"
                              "POINT_DATA 4\nFIELD f 1\nintensity 1 4 float\n1 2 3 4\n");
    const auto five =
        readText("b.vtk", "# vtk DataFile Version 5.1\nt\nASCII\n" + head +
                              "METADATA\nINFORMATION 0\n\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n0 4\n"
                              "CONNECTIVITY vtktypeint64\n0 1 2 3\n");
    for (const auto* loaded : {&three, &five}) {
        EXPECT_EQ(loaded->geometry.triangles.size(), 2);
        EXPECT_DOUBLE_EQ(surfaceArea(loaded->geometry), 1);
    }
    EXPECT_EQ(three.geometry.vertices.attributes().intensity, (std::vector<float>{1, 2, 3, 4}));
}

TEST(VtkFormat, ReadsBinaryGrids) {
    std::string text = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n";
    const std::string zero(4, '\0'), one("\x3f\x80\0\0", 4);
    text += zero + zero + zero + one + zero + zero + zero + one + zero;
    const auto word = [](char c) { return std::string(3, '\0') + c; };
    text += "\nCELLS 1 4\n" + word(3) + word(0) + word(1) + word(2) + "\nCELL_TYPES 1\n" + word(5) + "\n";
    const auto grid = readText("a.vtk", text);
    EXPECT_EQ(grid.geometry.triangles, (std::vector<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(grid.geometry.vertices.point(2), Eigen::Vector3d(0, 1, 0));
}

TEST(ObjFormat, KeepsUtmCoordinatesInDouble) {
    const auto obj =
        readText("a.obj",
                 "v 576661.9701 5188114.0602 156.06 1 0 0\nv 576662.9701 5188114.0602 156.06 0 1 0\n"
                 "v 576662.9701 5188115.0602 156.06 0 0 1\nf -3 -2/1 -1\n");
    EXPECT_LT((first(obj) - Eigen::Vector3d(576661.9701, 5188114.0602, 156.06)).norm(), 1e-6);
    EXPECT_EQ(obj.geometry.triangles, (std::vector<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(obj.geometry.vertices.attributes().color[2], (Color{0, 0, 65535}));
}

TEST(Formats, FilesOfEqualContentReadEqual) {
    VESTIGE_SHARED_OR_SKIP(folder, "formats");
    const auto sphere = readOrFail(folder / "ply/ply/sphere_ascii.ply").geometry;
    ASSERT_EQ(sphere.triangles.size(), 768);
    for (const char* name : {"ply/ply/sphere_bbe.ply", "ply/ply/sphere_ble.ply"}) {
        const auto other = readOrFail(folder / name).geometry;
        EXPECT_LT(largestDifference(sphere.vertices, other.vertices), 1e-5) << name;
        EXPECT_EQ(sphere.triangles, other.triangles);
    }
    for (const char* name : {"stl/stl/sphere_ascii.stl", "stl/stl/sphere_binary.stl"}) {
        const auto other = readOrFail(folder / name).geometry;
        EXPECT_EQ(other.triangles.size(), 768);
        EXPECT_NEAR(surfaceArea(other), surfaceArea(sphere), 1e-3) << name;
    }
    const auto utm = readOrFail(folder / "text/text/utm17_1.txt").geometry.vertices;
    for (const char* name : {"text/text/utm17_2.txt", "pcd/pcd/utm17_comma.pcd", "pcd/pcd/utm17_space.pcd",
                             "pcd/pcd/utm17_tab.pcd"})
        EXPECT_LT(largestDifference(utm, readOrFail(folder / name).geometry.vertices), 1e-6) << name;
}

TEST(Formats, PairsOfTheStreetAndTheApartmentRead) {
    VESTIGE_SHARED_OR_SKIP(folder, "registration");
    EXPECT_EQ(largestDifference(readOrFail(folder / "street/source.ply").geometry.vertices,
                                readOrFail(folder / "street/251371071.pcd").geometry.vertices),
              0);
    EXPECT_EQ(readOrFail(folder / "apartment/cloud_0.vtk").geometry.vertices.size(), 36674);
    EXPECT_EQ(readOrFail(folder / "apartment/cloud_1.vtk").geometry.vertices.size(), 36670);
    EXPECT_EQ(readOrFail(folder / "car/car_cloud400.csv").geometry.vertices.attributes().normal.size(),
              24989);
}
