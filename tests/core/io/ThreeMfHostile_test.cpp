#include <gtest/gtest.h>

#include "tests/core/io/Hostile.h"
#include "tests/core/io/ZipText.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

const std::string kModel =
    threeMfModel("meter", threeMfTetrahedron(1, "0.1", "0.1", "0.1"), "<item objectid=\"1\"/>");

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

}  // namespace

TEST(ThreeMf, KeepsCoordinatesThatAFloatCannotHold) {
    const TemporaryFolder folder;
    writeBytes(folder / "utm.3mf",
               zipOf(threeMfParts(threeMfModel(
                   "meter", threeMfTetrahedron(1, "576661.1234", "5188114.4321", "150.0001"),
                   "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 1000000.0625 0.5 -0.25\"/>"))));
    const LoadedGeometry found = readOrFail(folder / "utm.3mf");
    ASSERT_EQ(found.geometry.vertices.size(), 4);
    // (x, y, z) of the matrix above is (-y, x, z) and the translation.
    const Eigen::Vector3d expected(1000000.0625 - 5188114.4321, 576661.1234 + 0.5, 150.0001 - 0.25);
    EXPECT_LT((found.geometry.vertices.point(0) - expected).norm(), 1e-6);
    EXPECT_EQ(found.info.metresPerUnit, 1.0);
}

TEST(ThreeMf, TellsTheUnitAndLeavesTheCoordinatesInIt) {
    const TemporaryFolder folder;
    const std::pair<const char*, double> units[] = {{"micron", 1e-6},     {"millimeter", 1e-3},
                                                    {"centimeter", 1e-2}, {"inch", 0.0254},
                                                    {"foot", 0.3048},     {"meter", 1}};
    for (const auto& [unit, metres] : units) {
        writeBytes(folder / "a.3mf", zipOf(threeMfParts(replaced(kModel, "meter", unit))));
        const LoadedGeometry found = readOrFail(folder / "a.3mf");
        EXPECT_EQ(found.info.metresPerUnit, metres) << unit;
        ASSERT_EQ(found.geometry.vertices.size(), 4);
        EXPECT_NEAR(found.geometry.vertices.point(0).x(), 0.1, 1e-8);
    }
    expectRefusedWith(folder / "a.3mf", zipOf(threeMfParts(replaced(kModel, "meter", "furlong"))), "unit");
}

TEST(ThreeMfHostile, ArchivesThatLieAreRefusedBeforeTheyAreInflated) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::vector<ZipItem>& items, const std::string& words) {
        expectRefusedWith(folder / "a.3mf", zipOf(items), words);
    };
    const auto with = [&](ZipItem item) {
        std::vector<ZipItem> items = threeMfParts(kModel);
        items.push_back(std::move(item));
        return items;
    };
    refused(with({"../../etc/passwd", "x"}), "leads out of it");
    refused(with({"/etc/passwd", "x"}), "leads out of it");
    refused(with({"a\\..\\b", "x"}), "leads out of it");
    refused(with({"3D/3dmodel.model", "x"}), "twice");
    refused(with({"bomb", "xxxx", 0xfffffff0, -1, 8}), "together more than");
    refused(with({"3D/3dmodel.mode2", "", -1, 2}), "does not fit");
    refused(with({"secret", "x", -1, -1, 0, 1}), "encrypted");
    refused(with({"rare", "x", -1, -1, 99}), "encrypted or packed");
    refused(with({"lie", "x", 500}), "contradict");
    std::vector<ZipItem> twice = threeMfParts(kModel);
    twice.push_back({twice[2].name, "", 0, 2});
    refused(twice, "twice");
    std::vector<ZipItem> damaged = threeMfParts(kModel);
    damaged[2].method = 8;
    refused(damaged, "");
    expectRefusedWith(folder / "b.3mf", "PK\3\4 and nothing else at all", "no directory");
}

TEST(ThreeMfHostile, XmlThatExpandsOrReachesOutIsRefused) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& model) {
        expectRefusedWith(folder / "a.3mf", zipOf(threeMfParts(model)), "");
    };
    std::string bomb = "<!DOCTYPE model [<!ENTITY a \"0\">";
    for (char c = 'b'; c < 'z'; ++c)
        bomb += std::string("<!ENTITY ") + c + " \"" + std::string(1, '&') + static_cast<char>(c - 1) + ";&" +
                static_cast<char>(c - 1) + ";\">";
    refused(replaced(replaced(kModel, "<model", bomb + "]><model"), "\"0.1\"", "\"&y;\""));
    refused(replaced(
        replaced(kModel, "<model", "<!DOCTYPE model [<!ENTITY e SYSTEM \"file:///etc/passwd\">]><model"),
        "\"0.1\"", "\"&e;\""));
    refused(replaced(kModel, "\"0.1\"", "\"nan\""));
    refused(replaced(kModel, "\"0.1\"", "\"1e999\""));
    refused(replaced(kModel, "v1=\"0\"", "v1=\"4\""));
    refused(replaced(kModel, "v1=\"0\"", "v1=\"4294967295\""));
    refused(replaced(kModel, "objectid=\"1\"", "objectid=\"2\""));
    refused(replaced(kModel, "objectid=\"1\"", "objectid=\"1\" transform=\"1 0 0\""));
    refused(replaced(kModel, "</model>", ""));
    refused(
        replaced(kModel, "xml:lang", "xmlns:q=\"http://example.org/q\" requiredextensions=\"q\" xml:lang"));
}

TEST(ThreeMfHostile, ComponentsWithoutEndAreRefused) {
    const TemporaryFolder folder;
    std::string resources = threeMfTetrahedron(1, "0.1", "0.1", "0.1");
    for (int id = 2; id < 40; ++id) {
        const std::string component = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
        resources += "<object id=\"" + std::to_string(id) + "\" type=\"model\"><components>" + component +
                     component + "</components></object>";
    }
    expectRefusedWith(folder / "a.3mf",
                      zipOf(threeMfParts(threeMfModel("meter", resources, "<item objectid=\"39\"/>"))),
                      "objects hold each other too often");
    const std::string circle =
        "<object id=\"1\" type=\"model\"><components><component objectid=\"2\"/></components></object>"
        "<object id=\"2\" type=\"model\"><components><component objectid=\"1\"/></components></object>";
    expectRefusedWith(folder / "b.3mf",
                      zipOf(threeMfParts(threeMfModel("meter", circle, "<item objectid=\"1\"/>"))), "");
}

TEST(ThreeMfHostile, TrianglesRepeatedWithoutEndAreRefused) {
    const TemporaryFolder folder;
    // Four vertices and 20000 triangles, in 1500 places: 6000 vertices, but 30 million triangles.
    std::string triangles, items;
    for (int i = 0; i < 20000; ++i) triangles += "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>";
    for (int i = 0; i < 1500; ++i) items += "<item objectid=\"1\"/>";
    const std::string object =
        replaced(threeMfTetrahedron(1, "0.1", "0.1", "0.1"), "</triangles>", triangles + "</triangles>");
    expectRefusedWith(folder / "a.3mf", zipOf(threeMfParts(threeMfModel("meter", object, items))),
                      "repeats its objects until they have more than");
    writeBytes(folder / "b.3mf", zipOf(threeMfParts(threeMfModel("meter", object, items.substr(0, 40)))));
    EXPECT_EQ(readOrFail(folder / "b.3mf").info.triangles, 40008);
}

TEST(ThreeMfHostile, ARefusalQuotesTheFileInOneLine) {
    const TemporaryFolder folder;
    const auto file = folder / "a.3mf";
    writeBytes(file, zipOf(threeMfParts(replaced(kModel, "meter", "fur&#10;&#27;[2J\xc3long"))));
    const Result<LoadedGeometry> loaded = readGeometry(file);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().message, "the part '3D/3dmodel.model' names the unknown unit 'fur??[2J?long'");
    EXPECT_EQ(loaded.error().hint, "expected: a 3MF model");
}

TEST(ThreeMfHostile, TruncatedAndFlippedFilesAreReadOrRefused) {
    const TemporaryFolder folder;
    const std::string whole = zipOf(threeMfParts(kModel));
    writeBytes(folder / "whole.3mf", whole);
    EXPECT_EQ(readOrFail(folder / "whole.3mf").info.triangles, 4);
    for (std::size_t length = 4; length < whole.size(); length += 131) {
        writeBytes(folder / "cut.3mf", whole.substr(0, length));
        EXPECT_FALSE(readGeometry(folder / "cut.3mf")) << length;
        expectReadOrRefused(folder / "cut.3mf");
    }
    for (std::size_t at = 4; at < whole.size(); at += 37) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
        writeBytes(folder / "flipped.3mf", flipped);
        expectReadOrRefused(folder / "flipped.3mf");
    }
    VESTIGE_SHARED_OR_SKIP(malformed, "malformed/assimp/test/models/3MF/malformed_property_index_oob.3mf");
    expectReadOrRefused(malformed);
}
