#include <gtest/gtest.h>

#include <cmath>

#include "app/offscreen/OsMesaContext.h"
#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/OffscreenWindow.h"
#include "ui/view/SceneDrawing.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// A drawing without a window that keeps few points and draws few whole.
struct SmallDrawing {
    OffscreenWindow window{osMesaContext()};
    SceneDrawing drawing;

    SmallDrawing(std::size_t mostHeld, std::size_t wholeBelow)
        : drawing(window.renderWindow(), mostHeld, wholeBelow) {
        window.resize({400, 300});
    }
    void show(const ViewDescription& view) {
        drawing.show(view);
        drawing.setCamera(view.camera);
    }
    QImage complete() {
        drawing.beginPicture(1);
        return window.draw();
    }
};

/// Of a square of 2.25 million points, in 35 blocks.
const std::shared_ptr<const TriangleMesh>& square() {
    static const auto mesh = flatSquare(1500);
    return mesh;
}

/// Random points on a wavy square of 10 m, in tiles of 0.5 m of which every second is four times as dense.
std::shared_ptr<const TriangleMesh> waves(std::size_t count) {
    Random random(7);
    PointCloudBuilder builder;
    while (builder.size() < count) {
        const double x = random.uniform(0, 10);
        const double y = random.uniform(0, 10);
        const bool dense = (static_cast<int>(2 * x) + static_cast<int>(2 * y)) % 2 == 0;
        if (dense || random.below(4) == 0)
            builder.add(kFar + Eigen::Vector3d(x, y, 0.3 * std::sin(2 * x) * std::cos(3 * y)));
    }
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    return mesh;
}

/// One colour.
ViewDescription squareByHeight(NamedView view) {
    ViewDescription description = plainView(square(), view);
    description.colorMode = ColorMode::height;
    return description;
}

}  // namespace

TEST(ManyPoints, APictureAsksForNoMoreThanItsPixelsShow) {
    const ViewDescription view = plainView(square(), NamedView::top);
    SmallDrawing thinned(1 << 24, 0);
    thinned.show(view);
    // The square covers about 270 x 270 pixels, four points each.
    EXPECT_LT(thinned.drawing.pointsWanted(), 800'000U);
    EXPECT_GT(thinned.drawing.pointsWanted(), 270 * 270U);
    const QImage picture = thinned.complete();
    EXPECT_LT(thinned.drawing.pointsUploaded(), 810'000U) << "no more than it draws";
    SmallDrawing whole(1 << 24, SceneDrawing::kWholeBelow);
    whole.show(view);
    EXPECT_EQ(whole.drawing.pointsWanted(), 2'250'000U);
    EXPECT_EQ(picture, whole.complete()) << "what was left out shows nowhere";
}

TEST(ManyPoints, ThinningAnUnevenSurfaceLeavesItAsItIs) {
    for (const NamedView named : {NamedView::top, NamedView::perspective}) {
        ViewDescription view = plainView(waves(1'500'000), named);
        view.colorMode = ColorMode::height;
        view.camera =
            fitCamera({kFar - Eigen::Vector3d(5, 5, 1), kFar + Eigen::Vector3d(15, 15, 1)}, named, 400, 300);
        SmallDrawing thinned(1 << 24, 0);
        thinned.show(view);
        EXPECT_LT(thinned.drawing.pointsWanted(), 750'000U) << name(named);
        SmallDrawing whole(1 << 24, 1 << 24);
        whole.show(view);
        const QImage few = thinned.complete();
        const QImage all = whole.complete();
        int seen = 0;
        int holes = 0;
        int others = 0;
        for (int y = 0; y < all.height(); ++y)
            for (int x = 0; x < all.width(); ++x) {
                const QColor a = all.pixelColor(x, y);
                const QColor b = few.pixelColor(x, y);
                if (a.value() < 80) continue;
                ++seen;
                holes += b.value() < 80;
                others += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                              std::abs(a.blue() - b.blue()) >
                          60;
            }
        EXPECT_GT(seen, 5000) << name(named);
        EXPECT_LT(holes, 0.03 * seen) << name(named);
        EXPECT_LT(others, 0.05 * seen) << name(named);
    }
}

TEST(ManyPoints, PointsThatCoincideLeaveNoHoles) {
    // A tile merged several times; 90 x 90 pixels.
    const auto once = flatSquare(700);
    for (const int times : {2, 3}) {
        ViewDescription view = plainView(repeated(*once, times), NamedView::top);
        view.camera.halfHeight_m *= 3;
        SmallDrawing thinned(1 << 24, 0);
        thinned.show(view);
        EXPECT_LT(thinned.drawing.pointsWanted(), 150'000U * times);
        SmallDrawing whole(1 << 24, 1 << 24);
        whole.show(view);
        EXPECT_EQ(thinned.complete(), whole.complete()) << times;
    }
}

TEST(ManyPoints, NearPointsAreAllDrawn) {
    ViewDescription view = plainView(square(), NamedView::top);
    view.camera.halfHeight_m = 0.2;
    SmallDrawing small(1 << 24, 0);
    small.show(view);
    SmallDrawing whole(1 << 24, 1 << 24);
    whole.show(view);
    EXPECT_EQ(small.drawing.pointsWanted(), whole.drawing.pointsWanted());
    EXPECT_LT(small.drawing.pointsWanted(), 600'000U) << "blocks out of the picture take no part";
    EXPECT_EQ(small.complete(), whole.complete());
}

TEST(ManyPoints, WhatTheGraphicsCardHoldsIsBounded) {
    const ViewDescription view = squareByHeight(NamedView::perspective);
    constexpr std::size_t kHeld = 200'000;
    SmallDrawing small(kHeld, 1 << 24);
    small.show(view);
    const QImage picture = small.complete();
    EXPECT_GE(small.drawing.pointsUploaded(), 2'250'000U) << "every point passed through";
    EXPECT_LE(small.drawing.pointsHeld(), kHeld);
    SmallDrawing large(1 << 24, 1 << 24);
    large.show(view);
    EXPECT_EQ(picture, large.complete());
    EXPECT_EQ(small.complete(), picture) << "and again, from what it holds now";
    EXPECT_LE(small.drawing.pointsHeld(), kHeld);
}

TEST(ManyPoints, WhatIsHeldIsNotBroughtAgain) {
    const ViewDescription view = squareByHeight(NamedView::perspective);
    SmallDrawing small(1 << 24, 1 << 24);
    small.show(view);
    small.complete();
    const std::uint64_t once = small.drawing.pointsUploaded();
    small.complete();
    EXPECT_EQ(small.drawing.pointsUploaded(), once);
    ViewDescription recolored = view;
    recolored.colorMode = ColorMode::source;
    small.show(recolored);
    small.complete();
    EXPECT_EQ(small.drawing.pointsUploaded(), 2 * once) << "colours lie beside the positions";
}

TEST(ManyPoints, APassingPictureBringsLittleAndTheFirstOfEveryBlock) {
    const ViewDescription view = squareByHeight(NamedView::top);
    SmallDrawing small(1 << 24, 1 << 24);
    small.show(view);
    EXPECT_FALSE(small.drawing.beginPassingPicture(0.5, 20'000));
    const QImage first = small.window.draw();
    EXPECT_LE(small.drawing.pointsUploaded(), 20'000U + 256);
    // Points of every part of the square are there.
    for (const QPoint corner : {QPoint(100, 50), QPoint(300, 50), QPoint(100, 250), QPoint(300, 250)}) {
        int lit = 0;
        for (int y = -20; y < 20; ++y)
            for (int x = -20; x < 20; ++x)
                lit += qGray(first.pixel(corner.x() + x, corner.y() + y)) > 60 ? 1 : 0;
        EXPECT_GT(lit, 20) << corner.x() << " " << corner.y();
    }
    EXPECT_TRUE(small.drawing.beginPassingPicture(0.001, 20'000)) << "so much it holds";
}

TEST(ManyPoints, StepsAddUpToThePictureDrawnAtOnce) {
    const ViewDescription view = squareByHeight(NamedView::perspective);
    SmallDrawing steps(1 << 24, 1 << 24);
    steps.show(view);
    double share = steps.drawing.shareWithin(0, 1, 200'000);
    EXPECT_LT(share, 0.5);
    steps.drawing.beginPicture(share);
    QImage picture = steps.window.draw();
    std::uint64_t before = 0;
    while (share < 1) {
        EXPECT_LT(steps.drawing.pointsUploaded() - before, 260'000U);
        before = steps.drawing.pointsUploaded();
        share = steps.drawing.shareWithin(share, 1, 200'000);
        steps.drawing.addToPicture(share);
        picture = steps.window.draw();
    }
    EXPECT_EQ(picture, steps.complete()) << "no point is left out; of several colours, see the next test";
}

TEST(ManyPoints, WhatWasDrawnBeforeDoesNotShowInAPictureDrawnAtOnce) {
    // Two layers in one plane, wherever the steps before it ended.
    ViewDescription view = plainView(flatSquare(400), NamedView::top);
    view.layers.push_back(plainView(flatSquare(350), NamedView::top).layers[0]);
    view.layers[0].tint = {230, 40, 40};
    view.layers[1].tint = {40, 40, 230};
    view.pointSize_px = 1;
    SmallDrawing fresh(1 << 24, 1 << 24);
    fresh.show(view);
    const QImage atOnce = fresh.complete();
    int otherwise = 0;
    for (const std::vector<double>& ends :
         {std::vector<double>{0.02, 1}, {0.05, 0.5, 1}, {0.1, 0.3, 0.31, 0.97, 1}, {0.03, 0.04}}) {
        SmallDrawing steps(1 << 24, 1 << 24);
        steps.show(view);
        steps.drawing.beginPicture(ends.front());
        QImage picture = steps.window.draw();
        for (std::size_t i = 1; i < ends.size(); ++i) {
            steps.drawing.addToPicture(ends[i]);
            picture = steps.window.draw();
        }
        otherwise += picture != atOnce;
        EXPECT_EQ(steps.complete(), atOnce);
    }
    EXPECT_EQ(otherwise, 4) << "steps show, or this test sees nothing";
}
