#include <gtest/gtest.h>

#include <QApplication>
#include <QWidget>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/SceneView.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// A white square that lies 3 m further along x in the other picture of a comparison.
ViewDescription movedSquare(CompareMode mode) {
    ViewDescription view = plainView(flatSquare(120), NamedView::top);
    view.comparison = ViewComparison();
    view.comparison->mode = mode;
    ViewSide other{view.layers[0].worldFromLayer, true};
    other.worldFromLayer.pose.translation() += Eigen::Vector3d(3, 0, 0);
    view.layers[0].other = other;
    return view;
}

QImage picture(const ViewDescription& view) {
    const TemporaryFolder folder;
    EXPECT_TRUE(offscreenRenderer()->renderPng(view, folder / "p.png", {}));
    return readPicture(folder / "p.png").convertToFormat(QImage::Format_RGB32);
}

/// The two pictures that a comparison lays into each other, each drawn by itself.
struct Alone {
    QImage own;
    QImage other;
    explicit Alone(ViewDescription view) {
        view.comparison.reset();
        own = picture(view);
        view.layers[0].worldFromLayer = view.layers[0].other->worldFromLayer;
        other = picture(view);
    }
};

/// Share of the pixels in a place that are the same in both.
double alike(const QImage& a, const QImage& b, const QRect& place) {
    int same = 0;
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x) same += a.pixel(x, y) == b.pixel(x, y);
    return static_cast<double>(same) / (place.width() * place.height());
}

}  // namespace

TEST(Comparison, SwipeShowsTheOtherPictureLeftOfTheDivider) {
    ViewDescription view = movedSquare(CompareMode::swipe);
    view.comparison->divider = 0.4;
    const Alone alone(view);
    ASSERT_LT(alike(alone.own, alone.other, {0, 0, 400, 300}), 0.9);
    const QImage shown = picture(view);
    EXPECT_GT(alike(shown, alone.other, {0, 0, 140, 200}), 0.99);
    EXPECT_GT(alike(shown, alone.own, {180, 0, 220, 200}), 0.999);
}

TEST(Comparison, TilesShowBothInTurnFromTheTopLeft) {
    ViewDescription view = movedSquare(CompareMode::checkerboard);
    view.comparison->tile_px = 50;
    const Alone alone(view);
    const QImage shown = picture(view);
    const auto empty = [](const QColor& color) { return qGray(color.rgb()) < 40; };
    int faint = 0;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 8; ++column) {
            const bool isOwn = (row + column) % 2 == 0;
            const QImage& chosen = isOwn ? alone.own : alone.other;
            const QImage& hidden = isOwn ? alone.other : alone.own;
            for (int y = 50 * row + 6; y < 50 * row + 44; ++y)
                for (int x = 50 * column + 6; x < 50 * column + 44; ++x) {
                    const QColor now = shown.pixelColor(x, y);
                    if (!empty(chosen.pixelColor(x, y))) {
                        ASSERT_EQ(now, chosen.pixelColor(x, y)) << x << ", " << y;
                    } else if (empty(hidden.pixelColor(x, y))) {
                        ASSERT_EQ(now, chosen.pixelColor(x, y)) << "both are empty at " << x << ", " << y;
                    } else if (now != chosen.pixelColor(x, y)) {
                        ++faint;
                        ASSERT_GT(qGray(now.rgb()), 40);
                        ASSERT_LT(qGray(now.rgb()), 0.5 * qGray(hidden.pixel(x, y)));
                    }
                }
        }
    EXPECT_GT(faint, 1000) << "where a tile's own is empty the other one shows through";
}

TEST(Comparison, BlinkShowsOneOfThem) {
    ViewDescription view = movedSquare(CompareMode::blink);
    const Alone alone(view);
    const QRect aboveTheName(0, 0, 400, 200);
    EXPECT_GT(alike(picture(view), alone.own, aboveTheName), 0.999);
    view.comparison->otherShown = true;
    EXPECT_GT(alike(picture(view), alone.other, aboveTheName), 0.99);
}

TEST(Comparison, ALayerCanBeMissingInOnePicture) {
    ViewDescription view = movedSquare(CompareMode::swipe);
    view.layers[0].visible = false;
    const Alone alone([&] {
        ViewDescription visible = view;
        visible.layers[0].visible = true;
        return visible;
    }());
    const QImage shown = picture(view);
    EXPECT_GT(alike(shown, alone.other, {0, 0, 180, 200}), 0.99);
    const QRect right(220, 0, 180, 200);
    int bright = 0;
    for (int y = right.top(); y <= right.bottom(); ++y)
        for (int x = right.left(); x <= right.right(); ++x) bright += qGray(shown.pixel(x, y)) > 100;
    EXPECT_EQ(bright, 0);
}

TEST(Comparison, TheWindowFollowsTheDividerAndForgetsIt) {
    ViewDescription view = movedSquare(CompareMode::swipe);
    const Alone alone(view);
    QWidget window;
    SceneView shown(offscreenSurface(), &window);
    window.resize(400, 300);
    shown.widget()->resize(400, 300);
    window.show();
    QApplication::processEvents();
    shown.show(view);
    const auto grab = [&] { return shown.grab().convertToFormat(QImage::Format_RGB32); };
    for (const double divider : {0.2, 0.8}) {
        view.comparison->divider = divider;
        shown.setComparison(*view.comparison);
        const QImage now = grab();
        const int x = static_cast<int>(400 * divider);
        EXPECT_GT(alike(now, alone.other, {0, 0, x - 20, 120}), 0.99) << divider;
        EXPECT_GT(alike(now, alone.own, {x + 20, 0, 400 - x - 20, 120}), 0.99) << divider;
    }
    view.comparison.reset();
    shown.show(view);
    EXPECT_GT(alike(grab(), alone.own, {0, 0, 400, 300}), 0.999);
}

TEST(Comparison, AMovedLayerLooksAsIfBuiltThere) {
    ViewDescription view = plainView(flatSquare(120), NamedView::perspective);
    QWidget window;
    SceneView shown(offscreenSurface(), &window);
    window.resize(400, 300);
    shown.widget()->resize(400, 300);
    window.show();
    QApplication::processEvents();
    shown.show(view);
    static_cast<void>(shown.grab());
    Similarity moved;
    moved.pose = Eigen::Translation3d(kFar) * Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()) *
                 Eigen::Translation3d(-kFar + Eigen::Vector3d(1.5, -0.5, 0.25));
    view.layers[0].worldFromLayer = moved;
    shown.show(view);
    const QImage inWindow = shown.grab().convertToFormat(QImage::Format_RGB32);
    EXPECT_GT(alike(inWindow, picture(view), {0, 0, 400, 300}), 0.99);
}

TEST(Arrows, RunThroughBothEndsOfTheirPath) {
    ViewDescription view = plainView(flatSquare(120), NamedView::top);
    view.layers[0].tint = {30, 40, 30};
    view.arrows.push_back({{kFar + Eigen::Vector3d(2, 5, 0), kFar + Eigen::Vector3d(8, 5, 0)}, "slides"});
    const QImage with = picture(view);
    view.arrows.clear();
    const QImage without = picture(view);
    for (const double x : {2.3, 4.0, 6.0, 7.7}) {
        const auto at = view.camera.project(kFar + Eigen::Vector3d(x, 5, 0))->pixel;
        const QPoint pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
        EXPECT_GT(with.pixelColor(pixel).red(), 200) << x;
        EXPECT_LT(without.pixelColor(pixel).red(), 100) << x;
    }
}
