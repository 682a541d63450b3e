#include "core/measurement/MeasuredText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/Numbers.h"

namespace vestige {
namespace {

std::size_t decimals(const std::string& text) {
    const auto point = text.find('.');
    return point == std::string::npos ? 0 : text.size() - point - 1;
}

TEST(MeasuredText, GivesTheUncertaintyTwoDigitsAndTheLengthTheSamePlace) {
    // GUM 7.2.6: y = 10.057 62 with u = 27 thousandths becomes 10.058.
    EXPECT_EQ(measuredText(10.05762, 0.027).value, "10.058");
    EXPECT_EQ(measuredText(10.05762, 0.027).uncertainty, "0.027");
    EXPECT_EQ(measuredSentence(4.7863, 0.01437), "4.786 m \u00b1 0.014 m");
    EXPECT_EQ(measuredSentence(4.938, 0.104), "4.94 m \u00b1 0.10 m");
    EXPECT_EQ(measuredSentence(31.7, 12.4), "32 m \u00b1 12 m");
}

TEST(MeasuredText, KeepsTwoDigitsWhereRoundingCarries) {
    EXPECT_EQ(measuredSentence(2.3456, 0.0996), "2.35 m \u00b1 0.10 m");
    EXPECT_EQ(measuredSentence(2.3456, 0.994), "2.35 m \u00b1 0.99 m");
    EXPECT_EQ(measuredSentence(2.3456, 0.996), "2.3 m \u00b1 1.0 m");
}

TEST(MeasuredText, IsNeverFinerThanATenthOfAMillimetreAndThenRoundsUp) {
    EXPECT_EQ(measuredSentence(1.8400187, 0.00093), "1.8400 m \u00b1 0.0010 m");
    EXPECT_EQ(measuredSentence(0.27993, 0.00111), "0.2799 m \u00b1 0.0011 m");
    EXPECT_EQ(measuredSentence(1, 0.00034), "1.0000 m \u00b1 0.0004 m");
    EXPECT_EQ(measuredSentence(1, 0.0003), "1.0000 m \u00b1 0.0003 m");
    EXPECT_EQ(measuredSentence(1, 1e-12), "1.0000 m \u00b1 0.0001 m");
}

TEST(MeasuredText, ShowsMillimetresWhereNothingIsKnown) {
    EXPECT_EQ(measuredSentence(4.78634, std::nullopt), "4.786 m");
    EXPECT_EQ(measuredSentence(4.78634, 0), "4.786 m");
    EXPECT_EQ(measuredSentence(4.78634, std::numeric_limits<double>::infinity()), "4.786 m");
}

TEST(MeasuredText, NeverUnderstatesTheUncertaintyByMoreThanItsSecondDigit) {
    for (double u = 1e-5; u < 50; u *= 1.013) {
        const MeasuredText text = measuredText(3.14159265, u);
        const double told = *parseReal(text.uncertainty);
        EXPECT_GT(told, 0.95 * u) << text.uncertainty;
        EXPECT_LE(std::abs(*parseReal(text.value) - 3.14159265), 0.5 * told + 1e-12)
            << "the length is rounded within its uncertainty";
        EXPECT_EQ(decimals(text.value), decimals(text.uncertainty))
            << text.value << " and " << text.uncertainty << " end at one place";
    }
}

}  // namespace
}  // namespace vestige
