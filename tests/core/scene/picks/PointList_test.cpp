#include "core/scene/picks/PointList.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

std::vector<ListedPoint> read(const std::string& text) {
    const auto points = parsePointList(text, "picks.csv");
    EXPECT_TRUE(points) << (points ? "" : points.error().sentence()) << " in:\n" << text;
    return points.value_or(std::vector<ListedPoint>());
}

std::string refusalOf(const std::string& text) {
    const auto points = parsePointList(text, "picks.csv");
    EXPECT_FALSE(points) << text;
    return points ? std::string() : points.error().sentence();
}

struct Layout {
    const char* header;
    const char* first;  ///< before the coordinates, of the second row
    const char* label;
    bool indexed;
};

class Layouts : public testing::TestWithParam<std::tuple<char, bool>> {};

TEST_P(Layouts, GiveTheSamePoints) {
    const auto [separator, withHeader] = GetParam();
    for (const Layout& layout : {Layout{"x,y,z", "", "", false},
                                 {"local index,x,y,z", "17,", "17", true},
                                 {"global index,x,y,z", "4294967301,", "4294967301", true},
                                 {"label name,x,y,z", "Mirror,", "Mirror", false}}) {
        std::string text = withHeader ? std::string(layout.header) + "\n" : std::string();
        text += std::string(layout.first) + "518440.25,4326120.5,-3.125\r\n";
        text += std::string(layout.first) + "1e3,-2,+0.5\n\n";
        for (char& c : text)
            if (c == ',') c = separator;
        const auto points = read(text);
        ASSERT_EQ(points.size(), 2u) << text;
        EXPECT_EQ(points[0].position, Eigen::Vector3d(518440.25, 4326120.5, -3.125));
        EXPECT_EQ(points[1].position, Eigen::Vector3d(1000, -2, 0.5));
        EXPECT_EQ(points[1].label, layout.label);
        EXPECT_EQ(points[1].index.has_value(), layout.indexed);
        EXPECT_EQ(points[1].line, withHeader ? 3u : 2u);
    }
}

INSTANTIATE_TEST_SUITE_P(Separators, Layouts,
                         testing::Combine(testing::Values(',', ';', '\t', ' '), testing::Bool()));

TEST(PointList, LabelsMayHaveBlanksSeparatorsAndQuotes) {
    EXPECT_EQ(read("Left mirror, 1, 2, 3\n")[0].label, "Left mirror");
    EXPECT_EQ(read("Left mirror 1 2 3\n")[0].label, "Left mirror");
    EXPECT_EQ(read("\"Mirror, left\",1,2,3\n")[0].label, "Mirror, left");
    EXPECT_EQ(read("\"the \"\"good\"\" one\";1;2;3\n")[0].label, "the \"good\" one");
    EXPECT_EQ(read("#1,1,2,3\n")[0].label, "#1") << "no comment";
}

TEST(PointList, HeadersOfOtherProgramsAreHeaders) {
    for (const char* header :
         {"//X Y Z", "# x y z", "Label;X [m];Y [m];Z [m]", "name,E,N,H", "\xef\xbb\xbfx,y,z"})
        EXPECT_EQ(
            read(std::string(header) + (std::string(header).find(';') != std::string::npos   ? "\na;1;2;3"
                                        : std::string(header).find(',') != std::string::npos ? "\n1,2,3"
                                                                                             : "\n1 2 3"))
                .size(),
            1u)
            << header;
}

TEST(PointList, WhatIsWrongIsSaidWithItsLine) {
    EXPECT_EQ(refusalOf(""),
              "picks.csv: there are no points; expected x,y,z or index,x,y,z or label,x,y,z, decimal numbers "
              "with '.', parted by comma, semicolon, tab or blanks");
    EXPECT_NE(refusalOf("x,y,z\n").find("there are no points"), std::string::npos);
    EXPECT_NE(refusalOf("1,2,3\n1,2\n").find("picks.csv line 2: there are 2 cells"), std::string::npos);
    EXPECT_NE(refusalOf("1,2,3,4,5\n").find("there are 5 cells"), std::string::npos);
    EXPECT_NE(refusalOf("x,y,z\n1,2,3\n1,two,3\n").find("picks.csv line 3: y is not a number: 'two'"),
              std::string::npos);
    EXPECT_NE(refusalOf("1;2;3,5\n").find("expected a decimal number with '.'"), std::string::npos);
    for (const char* number : {"nan", "inf", "1e300", "0x10", "1.2.3", ""})
        EXPECT_NE(refusalOf("1,2," + std::string(number) + "\n").find("z is not a number"), std::string::npos)
            << number;
    EXPECT_NE(refusalOf("\"open,1,2,3\n").find("a quoted cell is not closed"), std::string::npos);
    // A second header is no point.
    EXPECT_NE(refusalOf("x,y,z\nx,y,z\n1,2,3\n").find("line 2"), std::string::npos);
}

TEST(PointList, AFileIsReadAsItsText) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "picks.txt") << "Point 0\t1\t2\t3\n";
    const auto points = readPointList(folder / "picks.txt");
    ASSERT_TRUE(points);
    EXPECT_EQ((*points)[0].label, "Point 0");
    EXPECT_FALSE(readPointList(folder / "none.txt"));
}

}  // namespace
}  // namespace vestige
