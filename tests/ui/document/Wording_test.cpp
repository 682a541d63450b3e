#include "ui/document/Wording.h"

#include <gtest/gtest.h>

namespace vestige {
namespace {

TEST(Wording, LengthsAndUncertainties) {
    EXPECT_EQ(lengthText(4.7861), "4.786");
    EXPECT_EQ(lengthText(0.08312), "0.0831");
    EXPECT_EQ(lengthText(std::nullopt), QString::fromUtf8("–"));
    EXPECT_EQ(uncertaintyText(0.01437), "0.014");
    EXPECT_EQ(uncertaintyText(0.00061), "0.0007");
    EXPECT_EQ(uncertaintyText(12.4), "12");
    EXPECT_EQ(uncertaintyText(std::nullopt), QString::fromUtf8("–"));
    EXPECT_EQ(distanceText(0.0148), "14.8 mm");
    EXPECT_EQ(distanceText(1.48), "1.480 m");
}

TEST(Wording, RelativeErrorsCarryTheirSign) {
    EXPECT_EQ(percentText(0.0004), "+0.04");
    EXPECT_EQ(percentText(-0.001), QString::fromUtf8("−0.10"));
    EXPECT_EQ(percentText(0.123), "+12.3");
    EXPECT_EQ(percentText(0.0), "0.00");
    EXPECT_EQ(fractionText(0.04271), "0.0427");
}

TEST(Wording, Counts) {
    EXPECT_EQ(countText(870), "870");
    EXPECT_EQ(countText(12345), "12.3 k");
    EXPECT_EQ(countText(5'000'000), "5.0 M");
}

TEST(Wording, SurveyCoordinatesAreGroupedAndNamed) {
    EXPECT_EQ(coordinateText(483400.579, 4375661.7058, 34.825),
              QString::fromUtf8("E 483\u2009400.579   N 4\u2009375\u2009661.706   H 34.825 m"));
    EXPECT_EQ(coordinateText(1.25, -0.31, 0.84), QString::fromUtf8("x 1.250   y −0.310   z 0.840 m"));
}

}  // namespace
}  // namespace vestige
