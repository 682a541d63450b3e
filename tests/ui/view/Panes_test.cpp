#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QtTest/QTest>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/SceneView.h"

using namespace vestige;
using namespace vestige::test;

namespace {

constexpr int kWidth = 600;
constexpr int kHeight = 400;

/// Notes where tools are offered a press, and what is under it.
struct PressNote : ViewTool {
    QPoint at;
    std::optional<Pick> pick;
    ViewCamera camera;
    bool mousePress(SceneView& view, const QMouseEvent& event) override {
        at = event.pos();
        pick = view.pickAt(event.pos());
        camera = view.camera();
        return true;
    }
};

struct FourViews {
    QWidget window;
    SceneView view{offscreenSurface(), &window};

    FourViews() {
        window.resize(kWidth, kHeight);
        view.widget()->resize(kWidth, kHeight);
        window.show();
        QApplication::processEvents();
        ViewDescription description = plainView(flatSquare(200), NamedView::perspective, kWidth, kHeight);
        // An upright wall beside the ground, so that every side shows something.
        description.layers.push_back(description.layers[0]);
        description.layers[1].id = "wall";
        Pose up = Pose::Identity();
        up.linear() =
            Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
        up.translation() = kFar - up.linear() * kFar;
        description.layers[1].worldFromLayer = {up, 1};
        view.show(description);
        std::vector<std::shared_ptr<const Octree>> octrees;
        for (const ViewLayer& layer : description.layers)
            octrees.push_back(std::make_shared<Octree>(
                std::shared_ptr<const PointCloud>(layer.geometry, &layer.geometry->vertices)));
        view.setPickIndex(octrees);
        view.completePicture();
    }

    QImage picture() {
        view.completePicture();
        return view.widget()->grab().toImage();
    }
};

QRect quarter(int pane) {
    return {pane % 2 * kWidth / 2, pane / 2 * kHeight / 2, kWidth / 2, kHeight / 2};
}

int bright(const QImage& picture, const QRect& part) {
    int count = 0;
    const QRect inner = part.adjusted(4, 4, -4, -4);
    for (int y = inner.top(); y <= inner.bottom(); ++y)
        for (int x = inner.left(); x <= inner.right(); ++x) count += qGray(picture.pixel(x, y)) > 100;
    return count;
}

}  // namespace

TEST(Panes, EachShowsTheSceneFromItsSide) {
    FourViews four;
    four.view.setLayout(ViewLayout::four);
    const QImage picture = four.picture();
    for (int pane = 0; pane < 4; ++pane) EXPECT_GT(bright(picture, quarter(pane)), 800) << pane;
    EXPECT_TRUE(four.view.isComplete());
    EXPECT_EQ(four.view.camera().width_px, kWidth / 2) << "the one there was is at the top right, and active";
    EXPECT_EQ(four.view.panePlace(), quarter(1));
    four.view.setLayout(ViewLayout::one);
    EXPECT_EQ(four.view.camera().width_px, kWidth);
    EXPECT_GT(bright(four.picture(), {0, 0, kWidth, kHeight}), 3000);
}

TEST(Panes, ShareThePointsOnTheCard) {
    FourViews four;
    const std::uint64_t before = four.view.pointsUploaded();
    four.view.setLayout(ViewLayout::four);
    four.picture();
    EXPECT_EQ(four.view.pointsUploaded(), before) << "what one view had, the others draw";
    four.view.setLayout(ViewLayout::one);
    four.picture();
    EXPECT_EQ(four.view.pointsUploaded(), before);
}

TEST(Panes, ATurnChangesOnlyItsOwn) {
    FourViews four;
    four.view.setLayout(ViewLayout::four);
    const QImage before = four.picture();
    QWidget* widget = four.view.widget();
    const QPoint in = quarter(2).center();
    QWheelEvent wheel(in, widget->mapToGlobal(in), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
    const QImage after = four.picture();
    for (const int pane : {0, 3}) EXPECT_EQ(before.copy(quarter(pane)), after.copy(quarter(pane))) << pane;
    EXPECT_NE(before.copy(quarter(2)), after.copy(quarter(2)));
}

TEST(Panes, AllPickWithTheirOwnCamera) {
    FourViews four;
    four.view.setLayout(ViewLayout::four);
    four.picture();
    PressNote note;
    four.view.setTool(&note);
    for (int pane = 0; pane < 4; ++pane) {
        // In the middle of the pane there may be nothing to pick; the first press makes it active.
        QTest::mousePress(four.view.widget(), Qt::LeftButton, Qt::NoModifier, quarter(pane).center());
        EXPECT_EQ(four.view.panePlace(), quarter(pane));
        QTest::mouseRelease(four.view.widget(), Qt::LeftButton, Qt::NoModifier, quarter(pane).center());
        const auto corner = four.view.camera().project(kFar);
        ASSERT_TRUE(corner);
        const QPoint place(static_cast<int>(corner->pixel.x()), static_cast<int>(corner->pixel.y()));
        QTest::mousePress(four.view.widget(), Qt::LeftButton, Qt::NoModifier,
                          place + quarter(pane).topLeft());
        QTest::mouseRelease(four.view.widget(), Qt::LeftButton, Qt::NoModifier,
                            place + quarter(pane).topLeft());
        EXPECT_EQ(note.at, place) << "in the pane's own coordinates";
        ASSERT_TRUE(note.pick) << pane;
        const auto seen = note.camera.project(note.pick->world);
        EXPECT_LT((seen->pixel - corner->pixel).norm(), 7) << pane;
    }
    four.view.setTool(nullptr);
}

TEST(Panes, MovingFramesStayCheapInAllOfThem) {
    FourViews four;
    four.view.setLayout(ViewLayout::four);
    four.picture();
    four.view.setSection(SectionBox{kFar, {3, 3, 3}, 0});
    for (int i = 0; i < 8; ++i) QTest::qWait(5);
    EXPECT_GT(four.view.movingFrame_s(), 0);
    EXPECT_LT(four.view.movingFrame_s(), 1.0);
}
