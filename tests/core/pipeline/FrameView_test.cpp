#include "core/pipeline/FrameView.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/PointCloudBuilder.h"

using namespace vestige;

namespace {

/// A site of 60 x 40 m at UTM coordinates with a few stray points far off.
ViewDescription site(bool strays) {
    PointCloudBuilder builder;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) builder.add({483000 + 0.6 * x, 4375000 + 0.4 * y, 35 + 0.01 * x});
    if (strays)
        for (int i = 0; i < 8; ++i) builder.add({483000 + 400.0 * i, 4375900, 135});
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    ViewDescription view;
    view.layers.push_back({"site", "site", mesh, nullptr, {}, {160, 180, 200}, nullptr, true, false});
    return view;
}

constexpr NamedView kViews[] = {NamedView::perspective, NamedView::top, NamedView::front, NamedView::left,
                                NamedView::iso};

}  // namespace

TEST(FrameView, FillsThePictureAndIgnoresStrayPoints) {
    const ViewDescription clean = site(false);
    for (const bool strays : {false, true}) {
        for (const NamedView named : kViews) {
            const ViewCamera camera = frameView(site(strays), named, 1400, 900);
            double widest = 0;
            int outside = 0;
            const PointCloud& cloud = clean.layers[0].geometry->vertices;
            for (std::size_t i = 0; i < cloud.size(); ++i) {
                const auto seen = camera.project(cloud.point(i));
                ASSERT_TRUE(seen);
                const double across = std::abs(seen->pixel.x() - 700) / 700;
                const double down = std::abs(seen->pixel.y() - 450) / 450;
                outside += across > 1 || down > 1;
                if (across <= 1 && down <= 1) widest = std::max({widest, across, down});
            }
            EXPECT_GT(widest, 0.85) << name(named);
            EXPECT_LE(outside, 40) << name(named);
        }
    }
}

TEST(FrameView, KeepsTheDirectionOfTheNamedView) {
    for (const NamedView named : kViews) {
        const ViewDescription view = site(true);
        const ViewCamera fitted = fitCamera(bounds(view), named, 1400, 900);
        const ViewCamera framed = frameView(view, named, 1400, 900);
        EXPECT_LT((fitted.direction() - framed.direction()).norm(), 1e-8) << name(named);
        EXPECT_EQ(fitted.parallel, framed.parallel);
    }
}

TEST(FrameView, AScanInAFrameOfItsOwnDoesNotMoveThePictureAway) {
    ViewDescription view = site(false);
    const ViewCamera alone = frameView(view, NamedView::perspective, 1400, 900);
    PointCloudBuilder builder;
    for (int i = 0; i < 1000; ++i) builder.add({0.01 * i, 0.02 * i, 0});
    auto scan = std::make_shared<TriangleMesh>();
    scan->vertices = std::move(builder).build();
    view.layers[0].isTarget = true;
    view.layers.insert(view.layers.begin(),
                       {"scan", "scan", scan, nullptr, {}, {244, 154, 52}, nullptr, true, false});
    const ViewCamera both = frameView(view, NamedView::perspective, 1400, 900);
    EXPECT_LT((both.position - alone.position).norm(), 1e-6);
    EXPECT_EQ(subjectLayers(view), std::vector<std::size_t>{1});
    view.layers[1].visible = false;
    EXPECT_EQ(subjectLayers(view), std::vector<std::size_t>{0});
}

TEST(FrameView, SeesTheEdgesOfACloudInRows) {
    // 2 million points, of which every 100th would be in one of ten columns.
    PointCloudBuilder builder;
    for (int row = 0; row < 2000; ++row)
        for (int column = 0; column < 1000; ++column)
            builder.add({483000 + 0.1 * column, 4375000 + 0.05 * row, 35});
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    ViewDescription view;
    view.layers.push_back({"scan", "scan", mesh, nullptr, {}, {160, 180, 200}, nullptr, true, false});
    const ViewCamera camera = frameView(view, NamedView::top, 900, 900);
    const Eigen::Vector2d low = camera.project({483000, 4375000, 35})->pixel;
    const Eigen::Vector2d high = camera.project({483099.9, 4375099.95, 35})->pixel;
    EXPECT_NEAR(low.x(), 36, 6);
    EXPECT_NEAR(high.x(), 864, 6);
    EXPECT_NEAR(low.y(), 864, 6);
    EXPECT_NEAR(high.y(), 36, 6);
}

TEST(FrameView, AnEmptySceneHasACamera) {
    const ViewCamera camera = frameView({}, NamedView::iso, 200, 100);
    EXPECT_TRUE(camera.position.allFinite());
    EXPECT_EQ(camera.width_px, 200);
}
