#include "core/scene/picks/TapeList.h"

#include <gtest/gtest.h>

#include "tests/core/scene/SampleScene.h"

namespace vestige {
namespace {

std::string refusalOf(const std::string& text) {
    const auto rows = parseTapeList(text, "tape.csv");
    EXPECT_FALSE(rows) << text;
    return rows ? std::string() : rows.error().sentence();
}

TEST(TapeList, TakesWhatMeasurementsCsvSaysOfTheTape) {
    const auto rows = parseTapeList(
        "object,method,tape_m,measured_1_m,re,excluded\r\n\"Mirror, "
        "left\",lidar,0.234,0.2341,0.0004,false\r\n"
        "\"Mirror, left\",photogrammetry,0.234,,,false\r\nSkid mark,lidar,,11.42,,false\r\n",
        "tape.csv");
    ASSERT_TRUE(rows) << rows.error().sentence();
    ASSERT_EQ(rows->size(), 2u);
    EXPECT_EQ((*rows)[0].object, "Mirror, left");
    EXPECT_EQ((*rows)[0].tape_m, 0.234);
    EXPECT_FALSE((*rows)[1].tape_m);
}

TEST(TapeList, TakesASheetOfTwoColumns) {
    for (const char* text :
         {"White vehicle;4.784\nWheel;0.63\n", "object\ttape_m\nWhite vehicle\t4.784\nWheel\t0.63",
          "Object;Tape m;kind\nWhite vehicle;4.784;\nWheel;0.63;circle\n"}) {
        const auto rows = parseTapeList(text, "tape.csv");
        ASSERT_TRUE(rows) << rows.error().sentence();
        ASSERT_EQ(rows->size(), 2u) << text;
        EXPECT_EQ((*rows)[1].object, "Wheel");
        EXPECT_EQ((*rows)[1].tape_m, 0.63);
    }
}

TEST(TapeList, ChangesOnlyWhatTheRowsSay) {
    const SceneState scene = test::sampleScene();
    const auto rows = parseTapeList(
        "object,tape_m,tape_resolution_m\nLength of the vehicle,4.95,\nWheel,0.63,0.001\n"
        "Right rearview mirror,,\n",
        "tape.csv");
    ASSERT_TRUE(rows) << rows.error().sentence();
    const auto changed = importTapes(scene, *rows);
    ASSERT_EQ(changed.size(), 2u) << "the mirror stays as it is";
    EXPECT_EQ(changed[0].tape_m, 4.95);
    EXPECT_EQ(changed[0].tapeResolution_m, 0.005);
    EXPECT_EQ(changed[0].picks, scene.measurements[0].picks);
    EXPECT_EQ(changed[1].object, "Wheel");
    EXPECT_EQ(changed[1].tapeResolution_m, 0.001);
}

TEST(TapeList, WhatIsWrongIsSaidWithItsLine) {
    EXPECT_NE(refusalOf("").find("there are no rows"), std::string::npos);
    EXPECT_NE(refusalOf("name,tape,x\na,1,2\n").find("tape.csv line 1: no column is called object"),
              std::string::npos);
    EXPECT_NE(refusalOf("Length 1;1,002\n").find("'1,002' has a decimal comma"), std::string::npos);
    EXPECT_NE(refusalOf("object,tape_m\n").find("no rows below the header"), std::string::npos);
    EXPECT_NE(refusalOf("object,tape_m\nA,1\n,2\n").find("tape.csv line 3: the object has no name"),
              std::string::npos);
    for (const char* value : {"-1", "0", "nan", "1e9", "\"4,93\"", "4 m"})
        EXPECT_NE(
            refusalOf("object,tape_m\nA," + std::string(value) + "\n").find("the tape value is no length"),
            std::string::npos)
            << value;
    EXPECT_NE(refusalOf("object,method,tape_m\nA,x,1\nA,y,2\n")
                  .find("tape.csv line 3: 'A' has another tape value here"),
              std::string::npos);
    EXPECT_NE(refusalOf("object,kind\nA,star\n").find("'star' is no kind of measurement"), std::string::npos);
}

}  // namespace
}  // namespace vestige
