#include "core/measurement/Accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vestige;

namespace {

/// Objects of 1 m taped, so that the relative errors are those given.
std::vector<AccuracyObject> withErrors(const std::vector<double>& errors) {
    std::vector<AccuracyObject> objects;
    for (const double error : errors)
        objects.push_back({"object " + std::to_string(objects.size()), 1.0, 1.0 + error, {}, false});
    return objects;
}

}  // namespace

TEST(Accuracy, ExcludesBeyondTwoSampleSdsOnce) {
    // 2 SD is 0.0647; without the 0.1 it would be 0.0224, and a second pass would take the 0.03 too.
    const auto method = methodAccuracy(
        "x", withErrors({0.005, -0.005, 0.005, -0.005, 0.005, -0.005, 0.005, -0.005, 0.03, 0.1}));
    EXPECT_EQ(method.n, 10U);
    EXPECT_NEAR(2 * *method.sd, 0.0647, 5e-5);
    EXPECT_EQ(method.excluded, std::vector<std::string>{"object 9"});
    EXPECT_TRUE(method.objects[9].excluded);
    EXPECT_FALSE(method.objects[8].excluded);
    EXPECT_NEAR(*method.rmse, std::sqrt((8 * 0.000025 + 0.0009) / 9), 1e-12);
    EXPECT_NEAR(*method.rmseAll, std::sqrt((8 * 0.000025 + 0.0009 + 0.01) / 10), 1e-12);
    EXPECT_NEAR(*method.rmseAbsolute_m, *method.rmseAll, 1e-12);
    EXPECT_FALSE(method.systematic);
}

TEST(Accuracy, TwoObjectsHaveAnSdButNoExclusion) {
    const auto method = methodAccuracy("x", withErrors({0.2, 0.21}));
    ASSERT_TRUE(method.sd);
    EXPECT_TRUE(method.excluded.empty());
    EXPECT_FALSE(method.systematic);
    EXPECT_FALSE(methodAccuracy("x", withErrors({0.2})).sd);
}

TEST(Accuracy, ErrorsThatAllPointOneWayAreSystematicAndStay) {
    const auto method = methodAccuracy("x", withErrors({0.10, 0.11, 0.09, 0.10}));
    EXPECT_TRUE(method.systematic);
    EXPECT_TRUE(method.excluded.empty());
    EXPECT_EQ(*method.rmse, *method.rmseAll);
    EXPECT_NEAR(method.meanRe, 0.1, 1e-12);
}

TEST(Accuracy, ExactlyHalfBeyondIsSystematic) {
    // 2 SD is 0.1039, so the two of 0.11 lie beyond it; two of four is half.
    const auto method = methodAccuracy("x", withErrors({0.11, 0.11, 0.02, 0.02}));
    ASSERT_LT(2 * *method.sd, 0.11);
    EXPECT_TRUE(method.systematic);
    EXPECT_TRUE(method.excluded.empty());
}

TEST(Accuracy, UnmeasuredObjectsStayListedAndDoNotCount) {
    auto objects = withErrors({0.01, 0.02, 0.03});
    objects[1].measured_m.reset();
    const auto method = methodAccuracy("x", objects);
    EXPECT_EQ(method.n, 2U);
    EXPECT_EQ(method.objects.size(), 3U);
    EXPECT_FALSE(method.objects[1].re);
    EXPECT_NEAR(*method.rmse, std::sqrt((0.0001 + 0.0009) / 2), 1e-12);
}

TEST(Accuracy, NothingMeasuredHasNoStatistics) {
    const auto method = methodAccuracy("x", {});
    EXPECT_EQ(method.n, 0U);
    EXPECT_FALSE(method.sd || method.rmse || method.rmseAll || method.rmseAbsolute_m);
}
