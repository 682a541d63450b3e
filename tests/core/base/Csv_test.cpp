#include "core/base/Csv.h"

#include <gtest/gtest.h>

using namespace vestige;

TEST(Csv, ReadsQuotesCommasAndBothLineEnds) {
    const auto rows = parseCsv("a,\"b,\"\"c\"\"\r\nd\",e\r\n\n1,,3\n", "x.csv");
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 2U);
    EXPECT_EQ((*rows)[0].cells, (std::vector<std::string>{"a", "b,\"c\"\r\nd", "e"}));
    EXPECT_EQ((*rows)[1].cells, (std::vector<std::string>{"1", "", "3"}));
    EXPECT_EQ((*rows)[1].line, 4U);
}

TEST(Csv, NamesTheLineOfAnOpenQuote) {
    const auto rows = parseCsv("a\n\"b", "x.csv");
    ASSERT_FALSE(rows);
    EXPECT_EQ(rows.error().place, "x.csv:2");
}

TEST(Csv, WritesWhatItReads) {
    const std::vector<std::string> cells{"plain", "with,comma", "with \"quote\"", "two\nlines", ""};
    const auto rows = parseCsv(csvLine(cells), "x.csv");
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->front().cells, cells);
}
