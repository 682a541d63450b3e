#include "ui/view/PointStore.h"

#include <gtest/gtest.h>

#include <memory>

#include "app/offscreen/OsMesaContext.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/OffscreenWindow.h"
#include "ui/view/SceneDrawing.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// A drawing in a context of its own.
struct Window {
    OffscreenWindow window{osMesaContext()};
    SceneDrawing drawing{window.renderWindow()};

    Window() { window.resize({400, 300}); }
    QImage picture(const ViewDescription& view) {
        drawing.show(view);
        drawing.setCamera(view.camera);
        return pictureAgain();
    }
    QImage pictureAgain() {
        drawing.beginPicture(1);
        return window.draw();
    }
    std::uint64_t uploaded() const { return drawing.pointsUploaded(); }
};

ViewLayer layer(const Rgb& tint, int side, const Eigen::Vector3d& aside) {
    ViewLayer layer = plainView(flatSquare(side, kFar + aside), NamedView::top).layers[0];
    layer.tint = tint;
    return layer;
}

/// Two squares of 62 500 points beside each other, in different colours.
ViewDescription twoLayers() {
    ViewDescription view = plainView(flatSquare(250), NamedView::top);
    view.layers[0].tint = {230, 40, 40};
    view.layers.push_back(layer({40, 230, 40}, 250, {12, 0, 0}));
    view.camera = fitCamera(bounds(view), NamedView::top, 400, 300);
    return view;
}

QImage drawnAfresh(const ViewDescription& view) {
    return Window().picture(view);
}

}  // namespace

TEST(PointStore, AStrayFarAwayDoesNotMakeTheOthersCoarse) {
    ViewDescription view = plainView(flatSquare(250), NamedView::top);
    view.camera = fitCamera(bounds(view), NamedView::top, 400, 300);
    const QImage alone = drawnAfresh(view);
    PointCloudBuilder builder;
    const PointCloud& square = view.layers[0].geometry->vertices;
    for (std::size_t i = 0; i < square.size(); ++i) builder.add(square.point(i));
    builder.add(Eigen::Vector3d::Zero());
    auto strayed = std::make_shared<TriangleMesh>();
    strayed->vertices = std::move(builder).build();
    view.layers[0].geometry = strayed;
    const QImage beside = drawnAfresh(view);
    int different = 0;
    for (int y = 0; y < alone.height(); ++y)
        for (int x = 0; x < alone.width(); ++x) different += alone.pixel(x, y) != beside.pixel(x, y);
    EXPECT_LT(different, alone.width() * alone.height() / 100);
}

TEST(PointStore, ALayerThatGoesLeavesThePagesOfTheOthers) {
    const ViewDescription both = twoLayers();
    Window window;
    window.picture(both);
    const std::uint64_t uploaded = window.uploaded();
    EXPECT_GE(uploaded, 125'000U);
    for (const std::size_t gone : {0, 1}) {
        ViewDescription one = both;
        one.layers.erase(one.layers.begin() + static_cast<std::ptrdiff_t>(gone));
        Window fresh;
        fresh.picture(both);
        EXPECT_EQ(fresh.picture(one), drawnAfresh(one)) << gone;
        EXPECT_EQ(fresh.uploaded(), uploaded) << "what stays was there, layer " << gone;
    }
}

TEST(PointStore, ALayerThatIsReplacedIsBroughtAlone) {
    ViewDescription view = twoLayers();
    Window window;
    window.picture(view);
    const std::uint64_t before = window.uploaded();
    // Of another square, as when the whole comes in the place of a first look, but no larger.
    view.layers[1].geometry = flatSquare(200, kFar + Eigen::Vector3d(12, 0, 0));
    EXPECT_EQ(window.picture(view), drawnAfresh(view));
    EXPECT_GE(window.uploaded() - before, 40'000U);
    EXPECT_LT(window.uploaded() - before, 40'000U + PointStore::kPage);
}

TEST(PointStore, GrowsWhileItHoldsPages) {
    ViewDescription view = twoLayers();
    Window window;
    window.picture(view);
    view.layers.push_back(layer({40, 40, 230}, 700, {0, 11, 0}));
    EXPECT_EQ(window.picture(view), drawnAfresh(view));
    view.layers.erase(view.layers.begin());
    EXPECT_EQ(window.picture(view), drawnAfresh(view));
    view.layers.clear();
    const QImage nothing = window.picture(view);
    EXPECT_EQ(nothing, drawnAfresh(view));
    EXPECT_EQ(window.drawing.pointsHeld(), 0U);
    EXPECT_EQ(window.picture(twoLayers()), drawnAfresh(twoLayers())) << "and begins anew";
}

TEST(PointStore, PagesGoWhenItGrows) {
    PointStore store(10 * PointStore::kPage);
    store.reserve(2);
    PointStore::Places first(3, PointStore::kNowhere);
    PointStore::Places second(3, PointStore::kNowhere);
    EXPECT_NE(store.add(first, 0), PointStore::kNowhere);
    EXPECT_NE(store.add(second, 2), PointStore::kNowhere);
    EXPECT_EQ(store.add(first, 1), PointStore::kNowhere) << "all that is held is in use";
    store.reserve(20);
    EXPECT_EQ(store.capacity(), 10U);
    EXPECT_EQ(store.pagesHeld(), 0U);
    EXPECT_FALSE(store.touch(first, 0));
    EXPECT_FALSE(store.touch(second, 2));
    EXPECT_NE(store.add(first, 0), PointStore::kNowhere);
    EXPECT_NE(store.add(second, 1), PointStore::kNowhere);
    store.drop(first);
    EXPECT_FALSE(store.touch(first, 0));
    EXPECT_TRUE(store.touch(second, 1));
    EXPECT_EQ(store.pagesHeld(), 1U);
    store.drop(second);
}

TEST(PointStore, WhatGoesInOneContextLeavesTheOther) {
    const ViewDescription view = twoLayers();
    auto one = std::make_unique<Window>();
    one->picture(view);
    Window other;
    const QImage picture = other.picture(view);
    const std::uint64_t uploaded = other.uploaded();
    // The other one's context is current from here on.
    ViewDescription less = view;
    less.layers.pop_back();
    one->drawing.show(less);
    EXPECT_EQ(other.pictureAgain(), picture) << "a layer of the first went";
    less.layers.clear();
    one->drawing.show(less);
    EXPECT_EQ(other.pictureAgain(), picture) << "all layers of the first went";
    EXPECT_EQ(one->picture(view), picture);
    EXPECT_EQ(other.pictureAgain(), picture);
    one.reset();
    EXPECT_EQ(other.pictureAgain(), picture) << "the first went";
    EXPECT_EQ(other.uploaded(), uploaded);
}
