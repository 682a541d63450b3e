#include "ui/view/SceneView.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QWheelEvent>
#include <QWidget>
#include <QtTest/QTest>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/view/Samples.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// A view of 400 x 300 pixels that is shown, with what it shows.
struct ShownView {
    QWidget window;
    SceneView view{offscreenSurface(), &window};

    explicit ShownView(const ViewDescription& description) {
        window.resize(400, 300);
        view.widget()->resize(400, 300);
        window.show();
        QApplication::processEvents();
        view.show(description);
        std::vector<std::shared_ptr<const Octree>> octrees;
        for (const ViewLayer& layer : description.layers)
            octrees.push_back(std::make_shared<Octree>(
                std::shared_ptr<const PointCloud>(layer.geometry, &layer.geometry->vertices)));
        view.setPickIndex(octrees);
        view.completePicture();
    }

    void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to) {
        QWidget* widget = view.widget();
        QTest::mousePress(widget, button, Qt::NoModifier, from);
        for (const QPoint& place : {(from + to) / 2, to}) {
            QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button,
                             Qt::NoModifier);
            QApplication::sendEvent(widget, &move);
        }
        QTest::mouseRelease(widget, button, Qt::NoModifier, to);
    }

    void turnWheel(const QPoint& place, int steps) {
        QWheelEvent wheel(place, view.widget()->mapToGlobal(place), {}, {0, 120 * steps}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view.widget(), &wheel);
    }
};

QPoint positionOf(const ViewCamera& camera, const Eigen::Vector3d& world) {
    const auto seen = camera.project(world);
    return seen ? QPoint(static_cast<int>(seen->pixel.x()), static_cast<int>(seen->pixel.y()))
                : QPoint(-1, -1);
}

/// Takes left clicks and counts what it is offered.
struct CountingTool : ViewTool {
    int moves = 0;
    int entered = 0;
    int left = 0;
    std::optional<Pick> picked;
    void enter(SceneView&) override { ++entered; }
    void leave(SceneView&) override { ++left; }
    bool mousePress(SceneView& view, const QMouseEvent& event) override {
        if (event.button() != Qt::LeftButton) return false;
        picked = view.pickAt(event.pos());
        return true;
    }
    bool mouseMove(SceneView&, const QMouseEvent&) override {
        ++moves;
        return false;
    }
};

}  // namespace

TEST(SceneView, ShowsTheSameAsAPicture) {
    const ViewDescription view = plainView(flatSquare(120), NamedView::perspective);
    const TemporaryFolder folder;
    ASSERT_TRUE(offscreenRenderer()->renderPng(view, folder / "p.png", {}));
    ShownView shown(view);
    EXPECT_EQ(shown.view.grab().convertToFormat(QImage::Format_RGB32),
              readPicture(folder / "p.png").convertToFormat(QImage::Format_RGB32));
}

TEST(SceneView, DraggingOrbitsRoundThePointUnderTheCursor) {
    ShownView shown(plainView(flatSquare(120), NamedView::perspective));
    const ViewCamera before = shown.view.camera();
    const QPoint start(150, 160);
    const auto pivot = shown.view.pickAt(start);
    ASSERT_TRUE(pivot);
    shown.drag(Qt::LeftButton, start, {210, 130});
    const ViewCamera after = shown.view.camera();
    EXPECT_GT((after.direction() - before.direction()).norm(), 0.2);
    EXPECT_LT((after.project(pivot->world)->pixel - before.project(pivot->world)->pixel).norm(), 0.01);
}

TEST(SceneView, WheelZoomsToTheCursor) {
    ShownView shown(plainView(flatSquare(120), NamedView::perspective));
    const ViewCamera before = shown.view.camera();
    const QPoint place(120, 170);
    const auto target = shown.view.pickAt(place);
    ASSERT_TRUE(target);
    shown.turnWheel(place, 3);
    const ViewCamera after = shown.view.camera();
    EXPECT_LT(after.project(target->world)->depth_m, 0.7 * before.project(target->world)->depth_m);
    EXPECT_LT((after.project(target->world)->pixel - before.project(target->world)->pixel).norm(), 0.01);
    shown.turnWheel(place, -3);
    EXPECT_LT((shown.view.camera().position - before.position).norm(), 1e-6);
}

TEST(SceneView, RightDragPans) {
    ShownView shown(plainView(flatSquare(120), NamedView::top));
    const Eigen::Vector3d world = kFar + Eigen::Vector3d(5, 5, 0);
    const QPoint before = positionOf(shown.view.camera(), world);
    shown.drag(Qt::RightButton, {200, 150}, {240, 120});
    EXPECT_EQ(positionOf(shown.view.camera(), world) - before, QPoint(40, -30));
}

TEST(SceneView, PicksThePointThatIsDrawnThere) {
    const auto square = flatSquare(21);  // 0.5 m apart
    ShownView shown(plainView(square, NamedView::top));
    const Eigen::Vector3d wanted = kFar + Eigen::Vector3d(3.5, 6, 0);
    const auto pick = shown.view.pickAt(positionOf(shown.view.camera(), wanted));
    ASSERT_TRUE(pick);
    EXPECT_LT((pick->world - wanted).norm(), 1e-6);
    EXPECT_FALSE(shown.view.pickAt({3, 3}));
    ViewDescription hidden = shown.view.description();
    hidden.layers[0].visible = false;
    shown.view.show(hidden);
    EXPECT_FALSE(shown.view.pickAt(positionOf(shown.view.camera(), wanted)));
}

TEST(SceneView, TheToolSeesEventsFirst) {
    ShownView shown(plainView(flatSquare(120), NamedView::perspective));
    CountingTool tool;
    shown.view.setTool(&tool);
    EXPECT_EQ(tool.entered, 1);
    const ViewCamera before = shown.view.camera();
    shown.drag(Qt::LeftButton, {150, 160}, {210, 130});
    EXPECT_TRUE(tool.picked);
    EXPECT_EQ(tool.moves, 2);
    EXPECT_EQ(shown.view.camera().position, before.position) << "the tool took the press, nothing orbits";
    shown.drag(Qt::RightButton, {150, 160}, {210, 130});
    EXPECT_NE(shown.view.camera().position, before.position) << "what it does not take still pans";
    QTest::mouseMove(shown.view.widget(), {100, 100});
    shown.view.setTool(nullptr);
    EXPECT_EQ(tool.left, 1);
}

TEST(SceneView, KeepsItsCameraUnlessAskedOtherwise) {
    ShownView shown(plainView(flatSquare(120), NamedView::perspective));
    shown.view.showNamedView(NamedView::top);
    const ViewCamera top = shown.view.camera();
    EXPECT_TRUE(top.parallel);
    shown.view.show(plainView(flatSquare(60), NamedView::front));
    EXPECT_EQ(shown.view.camera().position, top.position);
    shown.view.show(plainView(flatSquare(60), NamedView::front), true);
    EXPECT_NE(shown.view.camera().position, top.position);
}

TEST(SceneView, APendingMarkShowsAtOnce) {
    ViewDescription description = plainView(flatSquare(120), NamedView::top);
    description.layers[0].tint = {40, 60, 40};
    ShownView shown(description);
    const QImage before = shown.view.grab();
    shown.view.setPendingMark(
        ViewMark{kFar + Eigen::Vector3d(2, 5, 0), kFar + Eigen::Vector3d(8, 5, 0), "6.000 m", false});
    const QImage during = shown.view.grab();
    EXPECT_NE(before, during);
    const QPoint end = positionOf(shown.view.camera(), kFar + Eigen::Vector3d(2, 5, 0));
    EXPECT_GT(during.pixelColor(end).blue(), 150);
    shown.view.setPendingMark(std::nullopt);
    EXPECT_EQ(shown.view.grab(), before);
}

TEST(SceneView, AGrabbedPictureDoesNotDependOnTheStepsThatBuiltIt) {
    // Two layers in one plane: which of them a pixel shows is told by the order of drawing alone. The first
    // has a point a pixel, so that a part of it leaves pixels to the second.
    ViewDescription view = plainView(flatSquare(300), NamedView::top);
    view.layers.push_back(plainView(flatSquare(800), NamedView::top).layers[0]);
    view.layers[0].tint = {230, 40, 40};
    view.layers[1].tint = {40, 40, 230};
    view.pointSize_px = 1;
    const TemporaryFolder folder;
    ASSERT_TRUE(offscreenRenderer()->renderPng(view, folder / "p.png", {}));
    const QImage atOnce = readPicture(folder / "p.png").convertToFormat(QImage::Format_RGB32);
    const auto picture = [](QWidget& widget) {
        return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
    };
    int otherwise = 0;
    for (int run = 0; run < 4; ++run) {
        ShownView shown(view);
        EXPECT_EQ(picture(*shown.view.widget()), atOnce) << run;
        // Frames of other lengths, and so steps of other sizes; the last run grabs a picture half built.
        for (int turn = 0; turn < run; ++turn) {
            shown.turnWheel({200, 150}, turn % 2 == 0 ? 1 : -1);
            QTest::qWait(20 * turn);
        }
        shown.view.setCamera(view.camera);
        QElapsedTimer clock;
        clock.start();
        while (run < 3 && !shown.view.isComplete() && clock.elapsed() < 60000) QTest::qWait(1);
        if (run < 3) otherwise += picture(*shown.view.widget()) != atOnce;
        EXPECT_EQ(shown.view.grab().convertToFormat(QImage::Format_RGB32), atOnce) << run;
    }
    EXPECT_GT(otherwise, 0) << "steps show, or this test sees nothing";
}

TEST(SceneView, ManyPointsAreFilledInWhileEventsGoOn) {
    const ViewDescription view = plainView(flatSquare(1200), NamedView::top);
    const TemporaryFolder folder;
    ASSERT_TRUE(offscreenRenderer()->renderPng(view, folder / "p.png", {}));
    const QImage complete = readPicture(folder / "p.png").convertToFormat(QImage::Format_RGB32);
    ShownView shown(view);
    shown.turnWheel({200, 150}, 1);
    shown.turnWheel({200, 150}, -1);
    shown.view.setCamera(view.camera);
    QElapsedTimer clock;
    clock.start();
    const auto picture = [&] {
        return shown.view.widget()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    };
    while (clock.elapsed() < 60000 && picture() != complete) QTest::qWait(30);
    EXPECT_EQ(picture(), complete) << "added bit by bit, the picture ends as the one drawn at once";
}

TEST(SceneView, DrawsNoPointAgainForWhatIsPaintedOverThem) {
    ViewDescription description = plainView(flatSquare(120), NamedView::perspective);
    ShownView shown(description);
    ASSERT_TRUE(shown.view.isComplete());
    const QImage before = shown.view.grab();
    const BoundingBox square = bounds(description);
    description.marks.push_back({square.min, square.max, "1.414 m"});
    shown.view.show(description);
    EXPECT_TRUE(shown.view.isComplete());
    EXPECT_NE(shown.view.grab(), before) << "the mark is there";
    description.layers[0].tint = {10, 200, 10};
    description.colorMode = ColorMode::source;
    shown.view.show(description);
    EXPECT_FALSE(shown.view.isComplete());
}
