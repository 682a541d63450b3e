#include "core/base/Numbers.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

#include "core/base/Random.h"

using namespace vestige;

TEST(Numbers, ReadBackExactlyInAnyLocale) {
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const double value = random.normal(0, 1e6) * random.uniform();
        EXPECT_EQ(parseReal(exactText(value)), value);
    }
    EXPECT_EQ(exactText(0.1), "0.1");
    EXPECT_EQ(fixedText(0.04265, 4), "0.0427");
    EXPECT_EQ(parseReal("+1.5"), 1.5);
    EXPECT_FALSE(parseReal("1,5"));
    EXPECT_FALSE(parseReal(" 1"));
    EXPECT_FALSE(parseReal("+-1"));
    EXPECT_FALSE(parseInteger("1.0"));
    std::setlocale(LC_ALL, "C");
}

TEST(Numbers, DoublesBeyondAFloatAreItsLargest) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    constexpr float kLargest = std::numeric_limits<float>::max();
    EXPECT_EQ(toFloat(0.1), 0.1F);
    EXPECT_EQ(toFloat(kLargest), kLargest);
    EXPECT_EQ(toFloat(1e39), kLargest);
    EXPECT_EQ(toFloat(-1e300), -kLargest);
    EXPECT_EQ(toFloat(kInfinite), std::numeric_limits<float>::infinity());
    EXPECT_EQ(toFloat(-kInfinite), -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(toFloat(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Random, NormalNumbersHaveTheirMomentsAndRepeat) {
    Random random(3, 5);
    double sum = 0;
    double squares = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        const double value = random.normal();
        sum += value;
        squares += value * value;
    }
    EXPECT_NEAR(sum / kCount, 0, 4 / std::sqrt(kCount));
    EXPECT_NEAR(squares / kCount, 1, 4 * std::sqrt(2.0 / kCount));
    EXPECT_EQ(Random(3, 5).bits(), Random(3, 5).bits());
    EXPECT_NE(Random(3, 5).bits(), Random(3, 6).bits());
}
