#include "ui/view/PictureRenderer.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/AtomicFile.h"
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

}  // namespace

TEST(PictureRenderer, DrawsWithoutADisplay) {
    const QImage picture = drawn(plainView(flatSquare(120), NamedView::top));
    ASSERT_EQ(picture.size(), QSize(400, 300));
    EXPECT_GT(qGray(picture.pixel(200, 150)), 200);
    EXPECT_LT(qGray(picture.pixel(5, 5)), 40);
}
