#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QTest>
#include <QToolButton>

#include "core/scene/Edits.h"
#include "tests/ui/tools/PickDriver.h"
#include "ui/document/Document.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

using test::kBoxCorner;
using test::kBoxCornerAlongX;
using test::PickDriver;

const Eigen::Vector3d kMiddleOfTop(0, 0, 0.8);
const Eigen::Vector3d kOnGround(3.2, -3.2, 0);
/// Between the corners, on the edge along x.
const Eigen::Vector3d kOnEdge(0.2, -0.5, 0.8);

QAction& action(PickDriver& driver, const char* id) {
    return *driver.window().window().findChild<QAction*>(id);
}

TEST(Picking, TheLoupeSaysWhatAClickWouldTake) {
    PickDriver driver;
    driver.hover(driver.at(kMiddleOfTop));
    QTest::qWait(150);
    EXPECT_EQ(driver.caption(), "") << "nothing is picked with the tool Orbit";
    driver.window().trigger("tool.distance");
    driver.hover(driver.at(kMiddleOfTop));
    EXPECT_TRUE(driver.wait([&] { return driver.caption().startsWith("point, spacing"); }));
    driver.hover({2, 2});
    EXPECT_TRUE(driver.wait([&] { return driver.caption() == "no point here"; }));
    driver.hover(driver.at(kMiddleOfTop));
    EXPECT_TRUE(driver.wait([&] { return driver.caption().startsWith("point"); }));
    driver.window().trigger("view.front");
    EXPECT_EQ(driver.caption(), "") << "it showed the place of another camera";
    driver.window().trigger("view.top");
    driver.hover(driver.at(kMiddleOfTop));
    EXPECT_TRUE(driver.wait([&] { return !driver.caption().isEmpty(); }));
    driver.window().trigger("pick.loupe");
    driver.hover(driver.at(kMiddleOfTop) + QPoint(3, 0));
    QTest::qWait(150);
    EXPECT_EQ(driver.caption(), "");
}

TEST(Picking, EveryKindOfSnapIsChosenByItsActionAndInTurnByN) {
    PickDriver driver;
    auto* chooser = driver.window().window().findChild<QToolButton*>("snap");
    ASSERT_TRUE(chooser);
    EXPECT_FALSE(chooser->isVisible()) << "the tool Orbit picks nothing";
    driver.window().trigger("tool.distance");
    EXPECT_TRUE(chooser->isVisible());
    const std::vector<std::pair<const char*, const char*>> modes{
        {"snap.point", "point"},   {"snap.plane", "plane"},       {"snap.edge", "edge"},
        {"snap.corner", "corner"}, {"snap.highest", "highest"},   {"snap.lowest", "lowest"},
        {"snap.circle", "circle"}, {"snap.centroid", "centroid"}, {"snap.surface", "surface"}};
    for (const auto& [id, word] : modes) {
        EXPECT_TRUE(driver.window().trigger(id));
        EXPECT_EQ(chooser->text(), QString("Snap: %1").arg(word));
        EXPECT_TRUE(driver.hint().contains(QString(word) == "point" ? "nearest point" : word)) << word;
    }
    for (const auto& [id, word] : modes) {
        EXPECT_TRUE(driver.window().trigger("snap.next"));
        EXPECT_TRUE(action(driver, id).isChecked()) << id;
        int checked = 0;
        for (const auto& mode : modes) checked += action(driver, mode.first).isChecked();
        EXPECT_EQ(checked, 1);
    }
}

TEST(Picking, AnEdgeIsKeptBesideTheMeasuredPoint) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    driver.window().trigger("snap.edge");
    driver.hover(driver.at(kOnEdge));
    EXPECT_TRUE(driver.wait([&] { return driver.caption().startsWith("edge, σ"); }))
        << driver.caption().toStdString() << driver.hint().toStdString();
    driver.click(driver.at(kOnEdge));
    EXPECT_TRUE(driver.hint().contains("second end")) << driver.hint().toStdString();
    driver.window().trigger("snap.point");
    driver.click(driver.at(kOnGround));
    ASSERT_EQ(driver.scene().measurements.size(), 1U);
    const PickedPair& pair = driver.scene().measurements[0].picks.at("yard").at(0);
    ASSERT_TRUE(pair.a.fitted);
    EXPECT_EQ(pair.a.fitted->mode, SnapMode::edge);
    EXPECT_NEAR(pair.a.fitted->position.y(), -0.5, 0.005);
    EXPECT_NEAR(pair.a.fitted->position.z(), 0.8, 0.005);
    EXPECT_NEAR(std::abs(pair.a.fitted->axis.x()), 1, 1e-3);
    EXPECT_LT((pair.a.position - kOnEdge).norm(), 0.1) << "the point that the click hit";
    EXPECT_NEAR(std::remainder(pair.a.position.x(), 0.05), 0, 1e-4) << "a measured one";
    EXPECT_FALSE(pair.b.fitted);
}

TEST(Picking, EdgesOfABoxGiveItsSizes) {
    PickDriver driver{PickDriver::Box{}};
    driver.window().trigger("tool.distance");
    driver.window().trigger("snap.edge");
    for (const auto& [a, b] : {std::pair(Eigen::Vector3d(-1, 0, 0.8), Eigen::Vector3d(1, 0, 0.8)),
                               std::pair(Eigen::Vector3d(0.5, -0.5, 0.8), Eigen::Vector3d(0.5, 0.5, 0.8))}) {
        driver.window().trigger("object.add");
        driver.click(driver.at(a));
        EXPECT_TRUE(driver.hint().contains("second end")) << driver.hint().toStdString();
        driver.click(driver.at(b));
        const Measurement& last = driver.scene().measurements.back();
        ASSERT_TRUE(last.picks.contains("box")) << driver.hint().toStdString();
        const PickedPair& pair = last.picks.at("box").at(0);
        ASSERT_TRUE(pair.a.fitted && pair.b.fitted);
        const Eigen::Vector3d between = pair.b.fitted->position - pair.a.fitted->position;
        EXPECT_NEAR(between.cwiseAbs().maxCoeff(), (b - a).norm(), 0.005);
        EXPECT_NEAR(std::abs(pair.a.fitted->axis.dot((b - a).normalized())), 0, 0.01);
    }
}

TEST(Picking, WhereNoFeatureIsNothingIsTakenAndTheHintSaysWhy) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    driver.window().trigger("snap.corner");
    EXPECT_FALSE(driver.hint().contains("No corner"));
    driver.click(driver.at(kOnGround));
    EXPECT_TRUE(driver.hint().contains("first end"));
    EXPECT_TRUE(driver.hint().contains("No corner was found")) << driver.hint().toStdString();
    EXPECT_EQ(driver.caption(), "no corner here");
    EXPECT_TRUE(driver.scene().measurements.empty());
    driver.window().trigger("snap.next");
    EXPECT_FALSE(driver.hint().contains("No corner")) << "another snap, another answer";
}

TEST(Picking, WhatTheSectionCutsAwayOrALayerHidesIsNotPicked) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    SceneView& view = driver.window().window().view();
    ViewDescription cut = view.description();
    // Only what lies below 0.4 m is left: the top of the box is not.
    cut.section = SectionBox{{0, 0, 0}, {20, 20, 0.4}, 0};
    view.show(cut);
    const auto ground = view.pickAt(driver.at(kMiddleOfTop));
    ASSERT_TRUE(ground);
    EXPECT_NEAR(ground->world.z(), 0, 1e-6);
    cut.section.reset();
    view.show(cut);
    EXPECT_NEAR(view.pickAt(driver.at(kMiddleOfTop))->world.z(), 0.8, 1e-6);
    driver.window().window().document().perform(setLayerVisible("yard", false));
    EXPECT_FALSE(view.pickAt(driver.at(kMiddleOfTop)));
    driver.click(driver.at(kMiddleOfTop));
    EXPECT_TRUE(driver.hint().contains("first end"));
}

TEST(Picking, RightClickAndEscapeGoOneStepBackEach) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    driver.click(driver.at(kBoxCorner));
    ASSERT_TRUE(driver.hint().contains("second end"));
    driver.click({60, 60}, Qt::RightButton);
    EXPECT_TRUE(driver.hint().contains("first end"));
    EXPECT_TRUE(action(driver, "tool.distance").isChecked());
    driver.click({60, 60}, Qt::RightButton);
    EXPECT_TRUE(driver.wait([&] { return action(driver, "tool.orbit").isChecked(); }, 1000));
    EXPECT_EQ(driver.hint(), "");

    driver.window().trigger("tool.distance");
    driver.click(driver.at(kBoxCorner));
    driver.key(Qt::Key_Escape);
    EXPECT_TRUE(action(driver, "tool.distance").isChecked());
    driver.key(Qt::Key_Escape);
    EXPECT_TRUE(driver.wait([&] { return action(driver, "tool.orbit").isChecked(); }, 1000));
    EXPECT_TRUE(driver.scene().measurements.empty());
}

TEST(Picking, EscapeIsForThePairBeforeItIsForTheComparison) {
    PickDriver driver(true);
    ASSERT_TRUE(driver.window().trigger("compare.swipe"));
    driver.window().trigger("tool.distance");
    driver.hover(driver.at(kOnGround));
    driver.click(driver.at(kOnGround));
    ASSERT_TRUE(driver.hint().contains("second end"));
    driver.key(Qt::Key_Escape);
    EXPECT_TRUE(driver.hint().contains("first end"));
    EXPECT_TRUE(action(driver, "compare.swipe").isChecked());
}

TEST(Picking, ADoubleClickThatEndsAPairLeavesTheTool) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    driver.doubleClick(driver.at(kBoxCorner));
    QApplication::processEvents();
    EXPECT_TRUE(driver.hint().contains("second end"));
    EXPECT_TRUE(action(driver, "tool.distance").isChecked()) << "it was the first end";
    driver.doubleClick(driver.at(kBoxCornerAlongX));
    EXPECT_TRUE(driver.wait([&] { return action(driver, "tool.orbit").isChecked(); }, 1000));
    EXPECT_EQ(driver.scene().measurements.size(), 1U);
}

TEST(Picking, TheSamePointTwiceIsNoRepeat) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    driver.click(driver.at(kBoxCorner));
    driver.click(driver.at(kBoxCorner));
    EXPECT_TRUE(driver.scene().measurements.empty());
    EXPECT_TRUE(driver.hint().contains("click the other one")) << driver.hint().toStdString();
    driver.click(driver.at(kBoxCornerAlongX));
    EXPECT_EQ(driver.scene().measurements.size(), 1U);
}

TEST(Picking, RepeatsAreComparedAsTheyAreMade) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    driver.pickPair(kBoxCorner, kBoxCornerAlongX);
    EXPECT_TRUE(driver.hint().contains("1 repeat: 2.000 m")) << driver.hint().toStdString();
    driver.pickPair(kBoxCorner, kBoxCornerAlongX + Eigen::Vector3d(0, 0.2, 0));
    // sqrt(2^2 + 0.2^2) = 2.00998: mean 2.005, SD 7.1 mm.
    EXPECT_TRUE(driver.hint().contains("2 repeats: mean 2.005 m, SD 7.1 mm; the last one +10 mm"))
        << driver.hint().toStdString();
}

}  // namespace
}  // namespace vestige
