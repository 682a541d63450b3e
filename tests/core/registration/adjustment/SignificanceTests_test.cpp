#include "core/registration/adjustment/SignificanceTests.h"

#include <gtest/gtest.h>

namespace vestige {
namespace {

// Critical values of the tables in Abramowitz and Stegun, Handbook of Mathematical Functions, 26.8 and 26.9.
TEST(SignificanceTests, KeepToTheTablesOfChiSquare) {
    EXPECT_NEAR(chiSquareLimit(0.05, 2), 5.99146, 1e-5);
    EXPECT_NEAR(chiSquareLimit(0.05, 6), 12.5916, 1e-4);
    EXPECT_NEAR(chiSquareLimit(0.001, 6), 22.4577, 1e-4);
    EXPECT_NEAR(chiSquareLimit(0.05, 12), 21.0261, 1e-4);
    EXPECT_NEAR(chiSquareLimit(0.99, 30), 14.9535, 1e-4);
    EXPECT_NEAR(chiSquareTail(chiSquareLimit(0.2, 18), 18), 0.2, 1e-12);
}

TEST(SignificanceTests, StayFiniteFarOut) {
    EXPECT_EQ(chiSquareTail(0, 6), 1);
    EXPECT_EQ(chiSquareTail(1e6, 6), 0);
    EXPECT_NEAR(chiSquareTail(600, 600), 0.4923, 1e-3);
    EXPECT_EQ(fisherTail(0, 6, 6), 1);
    EXPECT_LT(fisherTail(1e8, 6, 6), 1e-20);
}

TEST(SignificanceTests, KeepToTheTablesOfF) {
    EXPECT_NEAR(fisherTail(4.28387, 6, 6), 0.05, 1e-6);
    EXPECT_NEAR(fisherTail(2.99612, 6, 12), 0.05, 1e-6);
    EXPECT_NEAR(fisherTail(8.379, 6, 12), 0.001, 1e-6);
    EXPECT_NEAR(fisherTail(19.0, 2, 2), 0.05, 1e-12);
}

}  // namespace
}  // namespace vestige
