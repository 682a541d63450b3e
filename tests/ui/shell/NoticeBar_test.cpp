#include "ui/shell/NoticeBar.h"

#include <gtest/gtest.h>

namespace vestige {
namespace {

TEST(NoticeBar, OffersGoWhenTheyAreWithdrawnAndNothingElse) {
    Notices notices;
    NoticeBar bar(notices);
    notices.offer("It does not fit", {{"Load every 4th point", [] {}}});
    EXPECT_EQ(bar.text(), "It does not fit");
    notices.withdrawOffers();
    EXPECT_EQ(bar.text(), "");
    notices.warn("The disk is full");
    notices.withdrawOffers();
    EXPECT_EQ(bar.text(), "The disk is full");
    notices.informOf("Written", "somewhere/report");
    notices.withdrawOffers();
    EXPECT_EQ(bar.text(), "Written");
}

}  // namespace
}  // namespace vestige
