#include "ui/shell/NoticeBar.h"

#include <gtest/gtest.h>

#include <QToolButton>

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

TEST(NoticeBar, OfTwoFilesBothOffersCanBeTaken) {
    Notices notices;
    NoticeBar bar(notices);
    QStringList taken;
    const auto offer = [&](const char* name, const char* group) {
        return Notices::Offer{name, [&taken, name] { taken << name; }, group};
    };
    notices.offer("Two are damaged", {offer("first", "a"), offer("second", "b"), offer("half of it", "b")});
    notices.warn("The disk is full");
    EXPECT_TRUE(bar.text().contains("The disk is full"));
    EXPECT_TRUE(bar.text().contains("Two are damaged"));
    bar.findChild<QToolButton*>("notice-button")->click();
    EXPECT_EQ(taken, QStringList("first"));
    notices.inform("Read");
    EXPECT_TRUE(bar.text().contains("Two are damaged")) << "the other can still be taken";
    bar.findChild<QToolButton*>("notice-button-2")->click();
    EXPECT_EQ(taken, (QStringList{"first", "half of it"}));
    EXPECT_EQ(bar.text(), "") << "one of the group is enough";
}

}  // namespace
}  // namespace vestige
