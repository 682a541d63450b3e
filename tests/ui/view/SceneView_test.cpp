#include "ui/view/SceneView.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QWidget>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/ui/view/Samples.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// A view of 400 x 300 pixels that is shown.
struct ShownView {
    QWidget window;
    SceneView view{offscreenSurface(), &window};

    ShownView() {
        window.resize(400, 300);
        view.widget()->resize(400, 300);
        window.show();
        QApplication::processEvents();
    }
};

}  // namespace

TEST(SceneView, ShowsTheSameAsAPicture) {
    ShownView shown;
    shown.view.show(plainView(flatSquare(120), NamedView::top));
    const QImage picture = shown.view.grab();
    ASSERT_EQ(picture.size(), QSize(400, 300));
    EXPECT_GT(qGray(picture.pixel(200, 150)), 200);
    EXPECT_LT(qGray(picture.pixel(5, 5)), 40);
}
