#include "core/measurement/AccuracyTable.h"

#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "tests/support/TestPaths.h"

using namespace vestige;

namespace {

std::vector<MethodAccuracy> oracle(const std::string& table) {
    const auto methods = readAccuracyTable(test::dataFile("oracles/" + table));
    if (!methods) throw std::runtime_error(methods.error().sentence());
    return *methods;
}

std::string errorOf(const std::string& text) {
    const test::TemporaryFolder folder;
    const auto file = folder / "table.csv";
    EXPECT_TRUE(writeTextFile(file, text));
    const auto methods = readAccuracyTable(file);
    if (methods) return "it was read";
    EXPECT_EQ(methods.error().code, ErrorCode::input);
    std::string sentence = methods.error().sentence();
    return sentence.substr(sentence.find("table.csv"));
}

using Names = std::vector<std::string>;

}  // namespace

TEST(AccuracyTable, Table5GivesThePublishedRmseAndExclusions) {
    const auto methods = oracle("table5.csv");
    ASSERT_EQ(methods.size(), 2U);
    EXPECT_EQ(methods[0].name, "photogrammetry");
    EXPECT_EQ(methods[0].n, 11U);
    EXPECT_NEAR(*methods[0].rmse, 0.0466, 5e-5);
    EXPECT_EQ(methods[0].excluded, Names{"Right rear-view mirror of the black vehicle"});
    EXPECT_EQ(methods[1].name, "lidar");
    EXPECT_NEAR(*methods[1].rmse, 0.0427, 5e-5);
    EXPECT_EQ(methods[1].excluded, (Names{"Right rear-view mirror of the white vehicle",
                                          "Right rear-view mirror of the black vehicle"}));
    EXPECT_NEAR(*methods[1].rmseAbsolute_m, 0.0355, 5e-5);
}

TEST(AccuracyTable, Table6GivesThePublishedRmseAndExclusions) {
    const auto methods = oracle("table6.csv");
    ASSERT_EQ(methods.size(), 2U);
    EXPECT_EQ(methods[0].n, 10U);  // mirror and handle were not measurable
    EXPECT_NEAR(*methods[0].rmse, 0.0581, 5e-5);
    EXPECT_TRUE(methods[0].excluded.empty());
    EXPECT_EQ(methods[1].n, 12U);
    EXPECT_NEAR(*methods[1].rmse, 0.0451, 5e-5);
    EXPECT_EQ(methods[1].excluded, Names{"Tripod length"});
    // 0.0714 stays, at a limit of 0.0719: the margin that rounding would lose.
    EXPECT_NEAR(2 * *methods[1].sd, 0.0719, 5e-5);
    EXPECT_NEAR(*methods[1].objects[9].re, 0.0714, 5e-5);
}

TEST(AccuracyTable, ErrorsNameLineColumnAndExpectation) {
    EXPECT_EQ(
        errorOf("object,tape_m,lidar_m\nbox,0.7,x\n"),
        "table.csv:2: 'x' in the column 'lidar_m' is not a length; expected metres such as 4.93, or nothing "
        "where it was not measured");
    EXPECT_EQ(errorOf("object,tape_m,lidar_m\nbox,0.7\n"),
              "table.csv:2: the row has 2 cells; expected 3, as in the first row");
    EXPECT_EQ(
        errorOf("object,tape,lidar_m\nbox,1,1\n"),
        "table.csv:1: the table has no column 'tape_m'; expected the columns object,tape_m,<name>_m,...");
    EXPECT_NE(errorOf("object;tape_m;lidar_m\nbox;0,7;0,7\n").find("the columns are parted by ';'"),
              std::string::npos);
    EXPECT_EQ(errorOf("object,tape_m\nbox,1\n"),
              "table.csv:1: the table has no column of measured lengths; expected the columns "
              "object,tape_m,<name>_m,...");
    EXPECT_EQ(errorOf("object,tape_m,lidar\nbox,1,1\n").substr(0, 43),
              "table.csv:1: column 3 is called 'lidar'; ex");
    EXPECT_EQ(errorOf("object,tape_m,a_m,a_m\nbox,1,1,1\n"),
              "table.csv:1: the column 'a_m' stands there twice");
    EXPECT_EQ(
        errorOf("object,tape_m,a_m\nbox,0,1\n"),
        "table.csv:2: the column 'tape_m' holds no length; expected the taped length in metres, above 0");
    EXPECT_EQ(errorOf("object,tape_m,a_m\nbox,1,inf\n").substr(0, 23), "table.csv:2: 'inf' in t");
    EXPECT_EQ(errorOf("object,tape_m,a_m\nbox,1,-1\n").substr(0, 22), "table.csv:2: '-1' in t");
    EXPECT_EQ(errorOf("object,tape_m,a_m\n"), "table.csv:1: the table has no row below its first");
    EXPECT_EQ(errorOf("").substr(0, 31), "table.csv:1: the table is empty");
}

TEST(AccuracyTable, ReadsQuotedNamesBlanksAndByteOrderMark) {
    const test::TemporaryFolder folder;
    const auto file = folder / "table.csv";
    ASSERT_TRUE(
        writeTextFile(file, "\xef\xbb\xbfobject, tape_m ,a_m\r\n\"Car, white\", 2 , 2.1 \r\nbox,1,\r\n"));
    const auto methods = readAccuracyTable(file);
    ASSERT_TRUE(methods) << methods.error().sentence();
    EXPECT_EQ(methods->front().objects[0].object, "Car, white");
    EXPECT_NEAR(*methods->front().objects[0].re, 0.05, 1e-12);
    EXPECT_FALSE(methods->front().objects[1].measured_m);
    EXPECT_FALSE(readAccuracyTable(folder / "absent.csv"));
}
