#include "core/report/AccuracyReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "tests/core/report/MeasuredExample.h"
#include "tests/core/report/ReportText.h"

namespace vestige {
namespace {

using testing::HasSubstr;

TEST(AccuracyReport, NamesTheExcludedAndShowsBothRmse) {
    const MeasuredScene scene = test::measuredExample();
    const Report report = accuracyReport(scene.accuracy, "table5.csv", "2026-01-01T00:00:00Z");
    const std::string text = test::textOf(report);
    EXPECT_THAT(text, HasSubstr("table5.csv"));
    EXPECT_THAT(
        text,
        HasSubstr("Excluded, because the relative error lies beyond twice the standard deviation: Box"));
    EXPECT_THAT(text, HasSubstr("\n1.00\t")) << "without the box";
    EXPECT_THAT(text, HasSubstr("not measurable"));
}

TEST(AccuracyReport, SaysThatErrorsAreSystematicInsteadOfExcludingHalf) {
    std::vector<AccuracyObject> objects;
    for (int i = 0; i < 4; ++i)
        objects.push_back({"object " + std::to_string(i), 1.0, 1.1 + 0.001 * i, {}, false});
    const Report report = accuracyReport({methodAccuracy("scaled", objects)}, "t.csv", "");
    EXPECT_THAT(test::textOf(report), HasSubstr("systematic"));
}

TEST(AccuracyReport, HasNothingToSayWithoutMethods) {
    EXPECT_TRUE(accuracyBlocks({}).empty());
}

}  // namespace
}  // namespace vestige
