#include "core/report/Wording.h"

#include <gtest/gtest.h>

namespace vestige {
namespace {

TEST(Wording, SignsPercentages) {
    EXPECT_EQ(signedPercent(0.0427), "+4.27");
    EXPECT_EQ(signedPercent(-0.0427), "\u22124.27");
    EXPECT_EQ(signedPercent(-0.00001), "0.00");
    EXPECT_EQ(percent(0.0466, 2), "4.66\u00a0%");
}

TEST(Wording, GroupsThousands) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(10342112), "10\u00a0342\u00a0112");
}

TEST(Wording, ListsAndCounts) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
    EXPECT_EQ(howMany(1, "object"), "1 object");
    EXPECT_EQ(howMany(3, "object"), "3 objects");
}

TEST(Wording, TellsDurations) {
    EXPECT_EQ(duration(8.26), "8.3 s");
    EXPECT_EQ(duration(125.2), "2 min 05 s");
    EXPECT_EQ(minutes(125), "2.08");
}

TEST(Wording, SaysADateAsPeopleReadIt) {
    EXPECT_EQ(readableDate("2026-11-22T08:07:57Z"), "22 November 2026, 08:07 UTC");
    EXPECT_EQ(readableDate("2026-03-05"), "5 March 2026");
    EXPECT_EQ(readableDate("2026-13-05"), "2026-13-05");
    EXPECT_EQ(readableDate("yesterday"), "yesterday");
}

}  // namespace
}  // namespace vestige
