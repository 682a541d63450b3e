#include "ui/view/PictureRenderer.h"

#include <gtest/gtest.h>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/AtomicFile.h"
#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/view/Samples.h"

using namespace vestige;
using namespace vestige::test;

namespace {

QImage drawn(const ViewDescription& view) {
    const TemporaryFolder folder;
    const auto renderer = offscreenRenderer();
    const Status written = renderer->renderPng(view, folder / "p.png", {});
    EXPECT_TRUE(written) << written.error().sentence();
    return readPicture(folder / "p.png");
}

constexpr NamedView kViews[] = {NamedView::perspective, NamedView::top, NamedView::front, NamedView::left,
                                NamedView::iso};

/// A wall across the view, 2 m behind a smaller one that covers its lower half.
ViewDescription stepInDepth(bool eyeDome) {
    ViewDescription view = plainView(flatSquare(500, {0, 0, 0}), NamedView::top);
    view.layers.push_back(view.layers[0]);
    view.layers[1].worldFromLayer.pose.translation() = Eigen::Vector3d(0, -5, 2);
    view.camera = fitCamera({{2, 2, 0}, {8, 8, 2}}, NamedView::top, 300, 300);
    view.eyeDomeLighting = eyeDome;
    return view;
}

}  // namespace

TEST(PictureRenderer, DrawsWithoutADisplay) {
    const QImage picture = drawn(plainView(flatSquare(120), NamedView::top));
    ASSERT_EQ(picture.size(), QSize(400, 300));
    EXPECT_GT(qGray(picture.pixel(200, 150)), 200);
    EXPECT_LT(qGray(picture.pixel(5, 5)), 40);
}

TEST(PictureRenderer, DrawsAPointWhereTheCameraProjectsIt) {
    for (const NamedView named : kViews) {
        for (const Eigen::Vector3d& aside : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(7.3, 2.1, 1.7)}) {
            ViewDescription view = plainView(onePoint(kFar + aside), named, 641, 487);
            view.camera = fitCamera({kFar - Eigen::Vector3d(1, 1, 1), kFar + Eigen::Vector3d(9, 5, 3)}, named,
                                    641, 487);
            view.pointSize_px = 5;
            const auto expected = view.camera.project(kFar + aside);
            ASSERT_TRUE(expected);
            const Spot spot = brightSpot(drawn(view));
            ASSERT_GT(spot.pixels, 0) << name(named);
            EXPECT_NEAR(spot.x, expected->pixel.x(), 0.75) << name(named);
            EXPECT_NEAR(spot.y, expected->pixel.y(), 0.75) << name(named);
        }
    }
}

TEST(PictureRenderer, MillimetresShowAtUtmCoordinates) {
    PointCloudBuilder builder;
    builder.add(kFar);
    builder.add(kFar + Eigen::Vector3d(0.002, 0, 0));
    builder.add(kFar + Eigen::Vector3d(80, 80, 0));  // keeps the display origin away from the pair
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    ViewDescription view = plainView(mesh, NamedView::top);
    view.camera =
        fitCamera({kFar - Eigen::Vector3d(0.002, 0.002, 0), kFar + Eigen::Vector3d(0.004, 0.002, 0)},
                  NamedView::top, 400, 300);
    view.pointSize_px = 4;
    const QImage picture = drawn(view);
    for (const double x : {0.0, 0.002}) {
        const auto at = view.camera.project(kFar + Eigen::Vector3d(x, 0, 0))->pixel;
        EXPECT_GT(qGray(picture.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()))), 150) << x;
    }
    const auto between = view.camera.project(kFar + Eigen::Vector3d(0.001, 0, 0))->pixel;
    EXPECT_LT(qGray(picture.pixel(static_cast<int>(between.x()), static_cast<int>(between.y()))), 50);
}

TEST(PictureRenderer, TheSameBytesOnEveryRunAndForAnyThreads) {
    const TemporaryFolder folder;
    ViewDescription view = plainView(flatSquare(600), NamedView::perspective);
    view.colorMode = ColorMode::height;
    view.showLegend = view.showScaleBar = true;
    view.marks.push_back({kFar, kFar + Eigen::Vector3d(8, 3, 0), "8.544 m", true});
    std::string first;
    for (const int threads : {1, 7, 2}) {
        setThreadCount(threads);
        const auto renderer = offscreenRenderer();
        ASSERT_TRUE(renderer->renderPng(view, folder / "p.png", {}));
        ASSERT_TRUE(renderer->renderPng(view, folder / "again.png", {}));
        const auto bytes = readTextFile(folder / "p.png");
        ASSERT_TRUE(bytes);
        EXPECT_TRUE(*bytes == readTextFile(folder / "again.png").value());
        if (first.empty()) first = *bytes;
        EXPECT_TRUE(*bytes == first) << threads;
    }
    setThreadCount(0);
}

TEST(PictureRenderer, NearPointsHideFarOnes) {
    ViewDescription view = plainView(flatSquare(400, {0, 0, 0}), NamedView::top);
    view.layers[0].tint = {255, 0, 0};
    view.layers.push_back(view.layers[0]);
    view.layers[1].tint = {0, 0, 255};
    view.layers[1].worldFromLayer.pose.translation().z() = 1;
    view.camera = fitCamera(bounds(view), NamedView::top, 400, 300);
    const QColor above = drawn(view).pixelColor(200, 150);
    EXPECT_GT(above.blue(), 150);
    EXPECT_LT(above.red(), 60);
    view.layers[1].visible = false;
    const QColor below = drawn(view).pixelColor(200, 150);
    EXPECT_GT(below.red(), 150);
}

TEST(PictureRenderer, EyeDomeLightingDarkensWhatLiesBehindAnEdge) {
    const QImage plain = drawn(stepInDepth(false));
    const QImage lit = drawn(stepInDepth(true));
    // The edge of the nearer wall is at y = 5 m; just behind it is shaded, far from it is not.
    const auto row = static_cast<int>(stepInDepth(true).camera.project({5, 5, 2})->pixel.y());
    EXPECT_LT(qGray(lit.pixel(150, row - 2)), qGray(plain.pixel(150, row - 2)) - 30);
    EXPECT_NEAR(qGray(lit.pixel(150, row - 60)), qGray(plain.pixel(150, row - 60)), 12);
    EXPECT_NEAR(qGray(lit.pixel(150, row + 60)), qGray(plain.pixel(150, row + 60)), 12);
}

TEST(PictureRenderer, DrawsMeshesAsSurfaces) {
    PointCloudBuilder builder;
    for (const Eigen::Vector3d& corner : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 0, 0),
                                          Eigen::Vector3d(10, 10, 0), Eigen::Vector3d(0, 10, 0)})
        builder.add(kFar + corner);
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    mesh->triangles = {{0, 1, 2}, {0, 3, 2}};  // the second is turned over
    const QImage picture = drawn(plainView(mesh, NamedView::top));
    EXPECT_GT(qGray(picture.pixel(160, 190)), 120);
    EXPECT_GT(qGray(picture.pixel(240, 110)), 120);
    EXPECT_LT(qGray(picture.pixel(5, 150)), 40);
}

TEST(PictureRenderer, MarksLieOnTopOfThePoints) {
    ViewDescription view = plainView(flatSquare(400, {0, 0, 0}), NamedView::top);
    view.layers[0].tint = {40, 60, 40};
    view.marks.push_back({{2, 5, -3}, {8, 5, -3}, "", false});  // under the points
    const auto middle = view.camera.project({5, 5, -3})->pixel;
    const QImage picture = drawn(view);
    EXPECT_GT(qGray(picture.pixel(static_cast<int>(middle.x()), static_cast<int>(middle.y()))), 180);
}

TEST(PictureRenderer, LegendAndScaleBarStandInTheirCorners) {
    ViewDescription view = plainView(flatSquare(100), NamedView::top);
    const QImage bare = drawn(view);
    view.showLegend = view.showScaleBar = true;
    const QImage full = drawn(view);
    const auto differs = [&](const QRect& place) { return bare.copy(place) != full.copy(place); };
    EXPECT_TRUE(differs({300, 0, 100, 60}));
    EXPECT_TRUE(differs({0, 240, 130, 60}));
    EXPECT_FALSE(differs({140, 80, 120, 120}));
}

TEST(PictureRenderer, AnUnwritablePlaceIsAnOutputErrorAndLeavesNothing) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "file", "x"));
    const auto renderer = offscreenRenderer();
    const Status status =
        renderer->renderPng(plainView(flatSquare(10), NamedView::top), folder / "file" / "p.png", {});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::output);
    EXPECT_EQ(readTextFile(folder / "file").value(), "x");
}

TEST(PictureRenderer, SizesThatCannotBeDrawnAreRefused) {
    const TemporaryFolder folder;
    ViewDescription view = plainView(flatSquare(10), NamedView::top);
    view.camera.width_px = 40000;
    const Status status = offscreenRenderer()->renderPng(view, folder / "p.png", {});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::usage);
    EXPECT_FALSE(std::filesystem::exists(folder / "p.png"));
}

TEST(PictureRenderer, AnEmptySceneIsAnEmptyPicture) {
    ViewDescription view;
    view.camera = fitCamera({}, NamedView::iso, 200, 100);
    view.showLegend = view.showScaleBar = false;
    EXPECT_EQ(brightSpot(drawn(view)).pixels, 0);
}
