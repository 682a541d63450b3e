#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QTest>
#include <QToolButton>

#include "tests/ui/tools/PickDriver.h"
#include "ui/document/Document.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

using test::kBoxCorner;
using test::kBoxCornerAlongX;
using test::PickDriver;

const Eigen::Vector3d kOnTop(0.3, 0.2, 0.8);
/// Between the corners, on the edge along x.
const Eigen::Vector3d kOnEdge(0.2, -0.5, 0.8);

struct PathPicks : testing::Test {
    PickDriver driver;

    PathPicks() { driver.window().trigger("tool.polyline"); }
    void pick(const std::vector<Eigen::Vector3d>& points) {
        for (const Eigen::Vector3d& point : points) driver.click(driver.at(point));
        driver.key(Qt::Key_Return);
        // Ends the editing of a new object's name.
        if (QWidget* focus = QApplication::focusWidget(); focus && focus != driver.view())
            QTest::keyClick(focus, Qt::Key_Return);
        driver.view()->setFocus();
    }
    const std::vector<PickedPath>& paths() { return driver.scene().measurements.at(0).paths.at("yard"); }
    const PickedPath& path(std::size_t repeat) { return paths().at(repeat); }
    std::string undoText() { return driver.window().textOf("edit.undo").toStdString(); }
    bool isChecked(const char* id) { return driver.window().window().findChild<QAction*>(id)->isChecked(); }
    const MeasuredScene& measured() { return driver.window().window().document().measured(); }
};

TEST_F(PathPicks, SnapAsThoseOfADistance) {
    auto* chooser = driver.window().window().findChild<QToolButton*>("snap");
    EXPECT_TRUE(chooser->isVisible()) << "what is snapped to can be chosen";
    driver.window().trigger("snap.edge");
    EXPECT_TRUE(driver.hint().contains("click the start on an edge")) << driver.hint().toStdString();
    driver.hover(driver.at(kOnEdge));
    EXPECT_TRUE(driver.wait([&] { return driver.caption().startsWith("edge, "); }))
        << driver.caption().toStdString();
    driver.click(driver.at(kOnEdge));
    EXPECT_TRUE(driver.hint().contains("click the next point")) << driver.hint().toStdString();
    driver.window().trigger("snap.point");
    driver.click(driver.at(kOnTop));
    driver.key(Qt::Key_Return);
    ASSERT_EQ(driver.scene().measurements.size(), 1U);
    ASSERT_EQ(path(0).size(), 2U);
    ASSERT_TRUE(path(0)[0].fitted);
    EXPECT_EQ(path(0)[0].fitted->mode, SnapMode::edge);
    EXPECT_NEAR(path(0)[0].fitted->position.y(), -0.5, 0.01);
    EXPECT_FALSE(path(0)[1].fitted);
    // Both ways are measured, and the budget of the fitted one takes what is known of the edge.
    ASSERT_EQ(measured().kinds.size(), 2U);
    EXPECT_EQ(measured().kinds[1].method, "lidar fitted");
    const auto& lines = measured().kinds[1].quantities.front().budget.contributions;
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [](const Contribution& line) { return line.source == "fitted features"; }));
    ASSERT_EQ(measured().lengths.size(), 2U);
    EXPECT_EQ(measured().lengths[1].method, "lidar fitted");
}

TEST_F(PathPicks, WhatIsNotFoundAddsNoPoint) {
    driver.window().trigger("snap.corner");
    driver.click(driver.at({3.2, -3.2, 0}));
    EXPECT_TRUE(driver.wait([&] { return driver.hint().contains("No corner"); }))
        << driver.hint().toStdString();
    driver.key(Qt::Key_Return);
    EXPECT_TRUE(driver.scene().measurements.empty());
    EXPECT_TRUE(driver.hint().contains("click the start"));
}

TEST_F(PathPicks, ACornerIsDraggedInOneStep) {
    pick({kBoxCorner, kBoxCornerAlongX, kOnTop});
    pick({kBoxCorner, kBoxCornerAlongX, kOnTop});
    const PickedPath before = path(0), other = path(1);
    const Eigen::Vector3d eye = driver.window().window().view().camera().position;
    const Eigen::Vector3d there(-0.4, 0.1, 0.8);
    driver.drag(driver.at(kOnTop), driver.at(there));
    // The handle of one of the two repeats, which lie on each other.
    const std::size_t moved = path(0) != before ? 0 : 1;
    EXPECT_EQ(path(1 - moved), moved == 0 ? other : before);
    EXPECT_LT((path(moved)[2].position - there).norm(), 0.06);
    EXPECT_EQ(path(moved)[1], before[1]);
    EXPECT_EQ(undoText(), "Undo move pick Polyline 1, repeat " + std::to_string(moved + 1));
    EXPECT_EQ(driver.window().window().view().camera().position, eye);
    const PickedPath now = path(moved);
    driver.window().trigger("edit.undo");
    EXPECT_EQ(path(moved), moved == 0 ? before : other);
    driver.window().trigger("edit.redo");
    EXPECT_EQ(path(moved), now);
}

TEST_F(PathPicks, EscapeDuringTheDragPutsTheCornerBack) {
    pick({kBoxCorner, kBoxCornerAlongX, kOnTop});
    const PickedPath before = path(0);
    driver.press(driver.at(kOnTop));
    driver.moveHeld(driver.at({-0.4, 0.1, 0.8}));
    EXPECT_TRUE(driver.wait([&] { return driver.hint().contains("Moving point 3 of repeat 1"); }, 3000))
        << driver.hint().toStdString();
    driver.key(Qt::Key_Escape);
    driver.release(driver.at({-0.4, 0.1, 0.8}));
    QTest::qWait(50);
    EXPECT_EQ(path(0), before);
    EXPECT_TRUE(isChecked("tool.polyline"));
}

TEST_F(PathPicks, ADraggedCornerIsSnappedAnew) {
    pick({kBoxCorner, kBoxCornerAlongX, kOnTop});
    driver.window().trigger("snap.edge");
    driver.drag(driver.at(kOnTop), driver.at(kOnEdge));
    EXPECT_TRUE(driver.wait([&] { return path(0)[2].fitted.has_value(); }, 3000));
    EXPECT_NEAR(path(0)[2].fitted->position.y(), -0.5, 0.01);
}

TEST_F(PathPicks, ArrowKeysMoveTheLastPointPixelByPixelInOneStep) {
    pick({kBoxCorner, kBoxCornerAlongX, kOnTop});
    const PickedPath before = path(0);
    const double pixel = driver.window().window().view().camera().metresPerPixel(1);
    const int steps = static_cast<int>(0.1 / pixel) + 1;
    for (int i = 0; i < steps; ++i) driver.key(Qt::Key_Left);
    EXPECT_EQ(path(0), before) << "it enters the case when it ends";
    EXPECT_TRUE(driver.wait([&] { return path(0)[2] != before[2]; }, 5000));
    EXPECT_NEAR(before[2].position.x() - path(0)[2].position.x(), 0.1, 0.06);
    EXPECT_EQ(path(0)[0], before[0]);
    EXPECT_EQ(undoText(), "Undo move pick Polyline 1, repeat 1");
}

TEST_F(PathPicks, TheRightButtonEndsAPathAndThenLeavesTheTool) {
    driver.click(driver.at(kBoxCorner));
    driver.click(driver.at(kBoxCornerAlongX));
    driver.click(driver.at(kOnTop), Qt::RightButton);
    ASSERT_EQ(paths().size(), 1U);
    EXPECT_TRUE(isChecked("tool.polyline"));
    driver.click(driver.at(kOnTop), Qt::RightButton);
    EXPECT_TRUE(driver.wait([&] { return isChecked("tool.orbit"); }));
}

TEST_F(PathPicks, ADistanceIsNoRepeatOfAPath) {
    pick({kBoxCorner, kBoxCornerAlongX, kOnTop});
    driver.window().trigger("tool.distance");
    driver.pickPair(kBoxCorner, kBoxCornerAlongX);
    ASSERT_EQ(driver.scene().measurements.size(), 2U);
    EXPECT_EQ(driver.scene().measurements[1].kind, MeasurementKind::distance);
    EXPECT_TRUE(driver.scene().measurements[0].picks.empty());
}

}  // namespace
}  // namespace vestige
