#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "core/base/Random.h"
#include "core/scene/CaseFile.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using vestige::test::TemporaryFolder;

namespace {

/// What reading `text` as case.json is answered with, from the file's name on.
std::string errorOf(const std::string& text) {
    static const TemporaryFolder folder;
    const auto file = folder / "case.json";
    EXPECT_TRUE(writeTextFile(file, text));
    const auto scene = readCase(file);
    if (scene) return "it was read";
    EXPECT_EQ(scene.error().code, ErrorCode::input);
    const std::string sentence = scene.error().sentence();
    return sentence.substr(std::min(sentence.size(), sentence.find("case.json")));
}

std::string errorOfLayer(const std::string& members) {
    return errorOf(R"({"vestige":1,"layers":[{"id":"a","role":"aerial","path":"a.las"},{)" + members + "}]}");
}

std::string errorOfMeasurement(const std::string& members) {
    return errorOf(R"({"vestige":1,"measurements":[{"object":"Box",)" + members + "}]}");
}

}  // namespace

TEST(CaseFileErrors, NameTheFileAndThePath) {
    EXPECT_EQ(errorOf("[]"),
              R"(case.json: this is no case of Vestige; expected an object with "vestige": 1)");
    EXPECT_EQ(errorOf(R"({"vestige":2})"),
              "case.json: vestige: the case is of a version that this program does not know; expected 1");
    EXPECT_EQ(errorOf(R"({"vestige":1,"layers":{}})"),
              "case.json: layers: there is an object here; expected an array");
    EXPECT_EQ(errorOf(R"({"vestige":1,"name":7})"), "case.json: name: there is 7 here; expected text");
    EXPECT_EQ(errorOf(R"({"vestige":1,"site":{"lat":91,"lon":0}})"),
              "case.json: site.lat: the latitude is beyond a pole; expected degrees from -90 to 90");
    EXPECT_EQ(errorOf(R"({"vestige":1,"registration":{"target":"a"}})"),
              "case.json: registration.target: the case has no layer 'a'; expected the id of a layer");
    EXPECT_EQ(errorOf(R"({"vestige":1,"preprocess":{"filter":"wiener"}})").substr(0, 73),
              "case.json: preprocess.filter: the value 'wiener' is not allowed for filte");
    EXPECT_EQ(errorOf(R"({"vestige":1,"preprocess":{"voxel_m":-1}})").substr(0, 30),
              "case.json: preprocess.voxel_m:");
    EXPECT_EQ(
        errorOf(
            R"({"vestige":1,"views":{"v":{"position":[0,0,0],"focal_point":[0,0,0],"view_up":[0,0,1]}}})"),
        "case.json: views.v: position and focal point coincide; expected a direction to look in");
}

TEST(CaseFileErrors, OfLayers) {
    EXPECT_EQ(errorOfLayer(R"("role":"aerial","path":"b")"),
              R"(case.json: layers[1]: the key "id" is missing)");
    EXPECT_EQ(errorOfLayer(R"("id":"a","role":"aerial","path":"b")"),
              "case.json: layers[1].id: two layers are called 'a'; expected ids that differ");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"tripod","path":"b")"),
              "case.json: layers[1].role: 'tripod' is no role; expected aerial, handheld or photogrammetry");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"aerial","path":"")"),
              "case.json: layers[1].path: the text is empty; expected a name");
    EXPECT_EQ(
        errorOfLayer(R"("id":"b","role":"aerial","path":"b","unit":"yd")"),
        "case.json: layers[1].unit: 'yd' is no unit of length; expected m, mm, cm, um, ft, ftUS, in or auto");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"aerial","path":"b","init":{"pose":[1,2]})"),
              "case.json: layers[1].init.pose: there are 2 values here; expected 16 numbers, the 4x4 matrix "
              "row by row");
    EXPECT_EQ(
        errorOfLayer(
            R"("id":"b","role":"aerial","path":"b","init":{"pose":[2,0,0,0,0,2,0,0,0,0,2,0,0,0,0,1]})"),
        "case.json: layers[1].init.pose: the rotation of the 4x4 pose is not orthonormal and right-handed; a "
        "scale belongs in its own field");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"aerial","path":"b","init":3)").substr(0, 49),
              "case.json: layers[1].init: this is no first pose;");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"aerial","path":"b","tint":[0,0,256])"),
              "case.json: layers[1].tint[2]: there is 256 here; expected a whole number from 0 to 255");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"aerial","path":"b\u0000c")"),
              "case.json: layers[1].path: the path holds a zero byte");
}

TEST(CaseFileErrors, OfMeasurements) {
    EXPECT_EQ(errorOfMeasurement(R"("tape_m":0)"),
              "case.json: measurements[0].tape_m: there is 0 here; expected a number above 0");
    EXPECT_EQ(errorOfMeasurement(R"("tape_m":"4.93")"),
              "case.json: measurements[0].tape_m: there is \"4.93\" here; expected a number");
    EXPECT_EQ(
        errorOfMeasurement(R"("picks":{"a":[[[1,2,3],[4,5]]]})"),
        "case.json: measurements[0].picks.a[0][1]: there are 2 values here; expected a point [x, y, z]");
    EXPECT_EQ(errorOfMeasurement(R"("picks":{"a":[[[1,2,null],[4,5,6]]]})"),
              "case.json: measurements[0].picks.a[0][0][2]: there is null here; expected a number");
    EXPECT_EQ(errorOfMeasurement(R"("picks":{"a":[{"a":["front",[1,2,3]]}]})"),
              R"(case.json: measurements[0].picks.a[0]: the key "b" is missing)");
    EXPECT_EQ(errorOfMeasurement(R"("picks":{"a":[[[1,2,3]]]})").substr(0, 73),
              "case.json: measurements[0].picks.a[0]: there are 1 values here; expected ");
    EXPECT_EQ(
        errorOf(R"({"vestige":1,"measurements":[{"object":"Box"},{"object":"Box"}]})"),
        "case.json: measurements[1].object: two measurements are called 'Box'; expected names that differ");
}

TEST(CaseFileErrors, OfTheJsonItself) {
    EXPECT_EQ(errorOf("{\n\"vestige\": 1,\n}"), "case.json:3: this is not JSON from byte 17 on");
    EXPECT_EQ(errorOf("").substr(0, 12), "case.json:1:");
    EXPECT_EQ(errorOf(R"({"vestige":1,"site":{"lat":1e999,"lon":0}})"),
              "case.json: a number is too large to be held");
    EXPECT_EQ(errorOf("{\"name\":\"\xff\"}").substr(0, 12), "case.json:1:");
    EXPECT_FALSE(readCase("absent.vestige"));
}

TEST(CaseFileErrors, HostileDepthAndSizeEndWithASentence) {
    EXPECT_EQ(errorOf(std::string(1000000, '[')), "case.json: the JSON is nested deeper than any case");
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += R"({"a":)";
    EXPECT_EQ(errorOf(objects), "case.json: the JSON is nested deeper than any case");
    std::string many = R"({"vestige":1,"layers":[)";
    for (int i = 0; i < 1000000; ++i) many += "{},";
    EXPECT_EQ(errorOf(many + "{}]}"), "case.json: the JSON holds more values than any case");
    // Brackets and commas inside text count for nothing.
    EXPECT_EQ(errorOf(R"({"vestige":1,"name":")" + std::string(2000, '[') + R"(\",\\"})"), "it was read");
    EXPECT_EQ(errorOf(std::string(65 << 20, ' ')),
              "case.json: the file is larger than a file of this kind can be");
    EXPECT_EQ(errorOf(R"({"vestige":1,"layers":[)" + std::string(1000000, '7') + "]}").substr(0, 12),
              "case.json: a");
}

TEST(CaseFileErrors, AKeyStandsOnceInAnObject) {
    EXPECT_EQ(errorOf(R"({"vestige":1,"name":"a","name":"b"})"),
              "case.json: the key \"name\" stands twice in one object; expected each key once");
    EXPECT_EQ(errorOf(R"({"vestige":1,"site":{"lat":1,"lon":2,"lat":3}})"),
              "case.json: the key \"lat\" stands twice in one object; expected each key once");
    EXPECT_EQ(errorOf(R"({"vestige":1,"name":"a","site":{"lat":1,"lon":2},"views":[]})").find("stands twice"),
              std::string::npos);
}

TEST(CaseFileErrors, PicksAreOnEarthAndForeignTextIsToldClean) {
    EXPECT_EQ(
        errorOfMeasurement(R"("tape_m":1,"picks":{"a":[[[0,0,1e11],[1,1,1]]]})"),
        "case.json: measurements[0].picks.a[0][0]: the point is farther from 0 than any place on Earth; "
        "expected up to 1e10");
    EXPECT_EQ(errorOfLayer(R"("id":"b","role":"\u001b[2J","path":"b.las")"),
              "case.json: layers[1].role: '?[2J' is no role; expected aerial, handheld or photogrammetry");
}

TEST(CaseFileErrors, AnyDamageIsAnErrorOrACase) {
    const TemporaryFolder folder;
    const auto file = folder / "case.json";
    ASSERT_TRUE(writeCase(file, test::sampleScene()));
    const std::string whole = *readTextFile(file);
    Random random(5);
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        std::string damaged = whole;
        if (i % 3 == 0) damaged.resize(random.below(damaged.size()));
        for (std::uint64_t k = 0; k <= random.below(3) && !damaged.empty(); ++k) {
            constexpr std::string_view kBytes = "[]{},:\"0-9e.nt\\\xff";
            damaged[random.below(damaged.size())] = kBytes[random.below(kBytes.size())];
        }
        ASSERT_TRUE(writeTextFile(file, damaged));
        const auto scene = readCase(file);
        if (scene) continue;
        ++refused;
        EXPECT_EQ(scene.error().code, ErrorCode::input);
        EXPECT_NE(scene.error().place.find("case.json"), std::string::npos) << scene.error().sentence();
    }
    EXPECT_GT(refused, 500);
}
