#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QTest>

#include "tests/ui/tools/PickDriver.h"
#include "ui/document/Document.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

using test::kBoxCorner;
using test::kBoxCornerAlongX;
using test::PickDriver;

/// 0.3 m from the corner along x, on the top of the box.
const Eigen::Vector3d kElsewhere(0.7, -0.3, 0.8);

struct MovingPicks : testing::Test {
    PickDriver driver;

    MovingPicks() {
        driver.window().trigger("tool.distance");
        driver.pickPair(kBoxCorner, kBoxCornerAlongX);
        driver.pickPair(kBoxCorner + Eigen::Vector3d(0, 0.5, 0),
                        kBoxCornerAlongX + Eigen::Vector3d(0, 0.5, 0));
    }
    const PickedPair& repeat(std::size_t index) {
        return driver.scene().measurements.at(0).picks.at("yard").at(index);
    }
    std::string undoText() { return driver.window().textOf("edit.undo").toStdString(); }
    Eigen::Vector3d eye() { return driver.window().window().view().camera().position; }
};

TEST_F(MovingPicks, ADraggedEndIsPickedAnewInOneStep) {
    const PickedPair before = repeat(0);
    const PickedPair other = repeat(1);
    const Eigen::Vector3d eyeBefore = eye();
    driver.drag(driver.at(kBoxCornerAlongX), driver.at(kElsewhere));
    EXPECT_EQ(undoText(), "Undo move pick Length 1, repeat 1");
    EXPECT_LT((repeat(0).b.position - kElsewhere).norm(), 0.06);
    EXPECT_EQ(repeat(0).a, before.a);
    EXPECT_EQ(repeat(1), other);
    EXPECT_EQ(eye(), eyeBefore);
    const PickedPair moved = repeat(0);
    driver.window().trigger("edit.undo");
    EXPECT_EQ(repeat(0), before);
    EXPECT_EQ(undoText(), "Undo pick Length 1, repeat 2");
    driver.window().trigger("edit.redo");
    EXPECT_EQ(repeat(0), moved);
}

TEST_F(MovingPicks, ADraggedEndIsSnappedAnew) {
    driver.window().trigger("snap.edge");
    driver.drag(driver.at(kBoxCornerAlongX), driver.at({0.4, -0.5, 0.8}));
    EXPECT_TRUE(driver.wait([&] { return repeat(0).b.fitted.has_value(); }, 3000));
    EXPECT_NEAR(repeat(0).b.fitted->position.z(), 0.8, 0.005);
    EXPECT_FALSE(repeat(0).a.fitted);
}

TEST_F(MovingPicks, EscapeDuringTheDragPutsItBack) {
    const PickedPair before = repeat(0);
    driver.press(driver.at(kBoxCornerAlongX));
    driver.moveHeld(driver.at(kElsewhere));
    EXPECT_TRUE(driver.wait([&] { return driver.hint().contains("was 2.000 m"); }, 3000))
        << driver.hint().toStdString();
    EXPECT_EQ(repeat(0), before) << "it enters the case when it ends";
    driver.key(Qt::Key_Escape);
    driver.release(driver.at(kElsewhere));
    QTest::qWait(100);
    EXPECT_EQ(repeat(0), before);
    EXPECT_EQ(undoText(), "Undo pick Length 1, repeat 2");
    EXPECT_TRUE(driver.window().window().findChild<QAction*>("tool.distance")->isChecked());
    EXPECT_TRUE(driver.hint().contains("first end")) << "the release picked nothing";
}

TEST_F(MovingPicks, WithAltADragTurnsTheViewAndAClickPicksNothing) {
    const PickedPair before = repeat(0);
    const Eigen::Vector3d eyeBefore = eye();
    driver.drag(driver.at(kBoxCornerAlongX), driver.at(kElsewhere), Qt::AltModifier);
    EXPECT_GT((eye() - eyeBefore).norm(), 0.1);
    EXPECT_EQ(repeat(0), before);
    driver.click(driver.at(kBoxCorner), Qt::LeftButton, Qt::AltModifier);
    EXPECT_TRUE(driver.hint().contains("first end"));
}

TEST_F(MovingPicks, AClickOnAnEndIsAPickAsEverywhere) {
    driver.click(driver.at(kBoxCorner));
    EXPECT_TRUE(driver.hint().contains("second end"));
    driver.click(driver.at(kBoxCornerAlongX));
    EXPECT_EQ(driver.scene().measurements[0].picks.at("yard").size(), 3U);
}

TEST_F(MovingPicks, TurningTheViewMovesThemOnlyWhereThatWasAskedFor) {
    driver.window().trigger("tool.orbit");
    const PickedPair before = repeat(0);
    Eigen::Vector3d eyeBefore = eye();
    driver.drag(driver.at(kBoxCornerAlongX), driver.at(kElsewhere));
    EXPECT_GT((eye() - eyeBefore).norm(), 0.1);
    EXPECT_EQ(repeat(0), before);
    driver.window().trigger("view.top");
    driver.window().trigger("pick.move");
    eyeBefore = eye();
    driver.drag(driver.at(kBoxCornerAlongX), driver.at(kElsewhere));
    EXPECT_EQ(eye(), eyeBefore);
    EXPECT_NE(repeat(0), before);
    EXPECT_EQ(undoText(), "Undo move pick Length 1, repeat 1");
    driver.drag(driver.at({3, 3, 0}), driver.at({2, 2, 0}));
    EXPECT_GT((eye() - eyeBefore).norm(), 0.1) << "beside the ends it turns the view";
}

TEST_F(MovingPicks, ArrowKeysMoveTheLastEndPixelByPixelInOneStep) {
    const PickedPair before = repeat(1);
    const double pixel = driver.window().window().view().camera().metresPerPixel(1);
    const int steps = static_cast<int>(0.1 / pixel) + 1;
    for (int i = 0; i < steps; ++i) driver.key(Qt::Key_Left);
    EXPECT_EQ(repeat(1), before) << "it enters the case when it ends";
    EXPECT_TRUE(driver.wait([&] { return repeat(1).b != before.b; }, 5000));
    EXPECT_NEAR(before.b.position.x() - repeat(1).b.position.x(), 0.1, 0.051);
    EXPECT_NEAR(before.b.position.y(), repeat(1).b.position.y(), 1e-9);
    EXPECT_EQ(undoText(), "Undo move pick Length 1, repeat 2");
    driver.window().trigger("edit.undo");
    EXPECT_EQ(repeat(1), before);
}

TEST_F(MovingPicks, EscapeGivesUpWhatTheKeysMoved) {
    const PickedPair before = repeat(1);
    for (int i = 0; i < 30; ++i) driver.key(Qt::Key_Left);
    driver.key(Qt::Key_Escape);
    QTest::qWait(1000);
    EXPECT_EQ(repeat(1), before);
    EXPECT_EQ(undoText(), "Undo pick Length 1, repeat 2");
    EXPECT_TRUE(driver.window().window().findChild<QAction*>("tool.distance")->isChecked());
}

}  // namespace
}  // namespace vestige
