#include <gtest/gtest.h>

#include <QColor>

#include "app/offscreen/OffscreenApplication.h"
#include "app/offscreen/OsMesaContext.h"
#include "core/base/AtomicFile.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/PictureRenderer.h"

using namespace vestige;
using namespace vestige::test;

namespace {

QImage drawn(ViewRenderer& renderer, const ViewDescription& view) {
    const TemporaryFolder folder;
    const Status written = renderer.renderPng(view, folder / "p.png", {});
    EXPECT_TRUE(written) << written.error().sentence();
    return readPicture(folder / "p.png");
}

/// Share of the pixels that differ visibly.
double differing(const QImage& a, const QImage& b) {
    long count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 12;
    return static_cast<double>(count) / (static_cast<double>(a.width()) * a.height());
}

}  // namespace

TEST(PictureParts, LookLikeThePictureInOne) {
    for (const NamedView named : {NamedView::perspective, NamedView::top, NamedView::iso}) {
        ViewDescription view = plainView(flatSquare(220), named, 700, 500);
        view.layers.push_back(view.layers[0]);
        view.layers[1].worldFromLayer.pose.translation() = Eigen::Vector3d(1, 2, 1.5);
        view.layers[1].tint = {200, 90, 60};
        view.showScaleBar = true;
        const QImage whole = drawn(*offscreenRenderer(), view);
        const auto inParts = pictureRenderer(osMesaContext, 200);
        const QImage parts = drawn(*inParts, view);
        ASSERT_EQ(parts.size(), whole.size());
        EXPECT_LT(differing(whole, parts), 0.004) << name(named);
    }
}

TEST(PictureParts, ATransparentPictureHasNoBackground) {
    ViewDescription view = plainView(flatSquare(200), NamedView::top, 300, 200);
    view.transparent = true;
    const QImage picture = drawn(*offscreenRenderer(), view);
    ASSERT_TRUE(picture.hasAlphaChannel());
    EXPECT_EQ(qAlpha(picture.pixel(5, 5)), 0);
    EXPECT_EQ(qAlpha(picture.pixel(150, 100)), 255);
}

TEST(PictureParts, SayTheirDotsPerInch) {
    ViewDescription view = plainView(flatSquare(50), NamedView::top, 300, 200);
    view.scale = {100.0, 300.0};
    view.showScaleBar = true;
    const QImage picture = drawn(*offscreenRenderer(), view);
    EXPECT_EQ(picture.dotsPerMeterX(), 11811);
    EXPECT_EQ(picture.dotsPerMeterY(), 11811);
}
