#include "ui/tools/LoupePicture.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QWidget>
#include <ctime>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

using test::kFar;
using test::plainView;

struct ShownView {
    QWidget window;
    SceneView view{offscreenSurface(), &window};

    explicit ShownView(ViewDescription description) {
        for (ViewLayer& layer : description.layers)
            layer.octree = std::make_shared<Octree>(
                std::shared_ptr<const PointCloud>(layer.geometry, &layer.geometry->vertices));
        window.resize(400, 300);
        view.widget()->resize(400, 300);
        window.show();
        QApplication::processEvents();
        view.show(std::move(description));
        view.completePicture();
    }
    QPointF seen(const Eigen::Vector3d& world) const {
        const auto at = view.camera().project(world);
        return {at->pixel.x(), at->pixel.y()};
    }
};

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TEST(LoupePicture, MagnifiesRoundThePlaceAskedFor) {
    const ShownView shown(plainView(test::onePoint(kFar), NamedView::top));
    LoupePicture loupe;
    const QPointF place = shown.seen(kFar);
    const test::Spot middle = test::brightSpot(loupe.draw(shown.view, place, 6, 120));
    EXPECT_NEAR(middle.x, 60, 0.51);
    EXPECT_NEAR(middle.y, 60, 0.51);
    const test::Spot aside = test::brightSpot(loupe.draw(shown.view, place + QPointF(3, -5), 6, 120));
    EXPECT_NEAR(aside.x, 60 - 18, 0.51);
    EXPECT_NEAR(aside.y, 60 + 30, 0.51);
    EXPECT_EQ(test::brightSpot(loupe.draw(shown.view, place + QPointF(40, 0), 6, 120)).pixels, 0);
}

TEST(LoupePicture, LeavesOutWhatIsHiddenAndCutAway) {
    ViewDescription view = plainView(test::onePoint(kFar), NamedView::top);
    const ShownView whole(view);
    LoupePicture loupe;
    const QPointF place = whole.seen(kFar);
    ASSERT_GT(test::brightSpot(loupe.draw(whole.view, place, 6, 120)).pixels, 0);
    const ViewCamera camera = whole.view.camera();
    view.camera = camera;
    view.section = SectionBox{kFar + Eigen::Vector3d(5, 0, 0), {1, 1, 1}, 0};
    EXPECT_EQ(test::brightSpot(loupe.draw(ShownView(view).view, place, 6, 120)).pixels, 0);
    view.section.reset();
    view.layers[0].visible = false;
    EXPECT_EQ(test::brightSpot(loupe.draw(ShownView(view).view, place, 6, 120)).pixels, 0);
}

TEST(LoupePicture, TheNearerPointIsOnTop) {
    ViewDescription view = plainView(test::onePoint(kFar), NamedView::top);
    ViewLayer above = view.layers[0];
    above.id = "above";
    above.geometry = test::onePoint(kFar + Eigen::Vector3d(0, 0, 1));
    above.tint = {255, 0, 0};
    view.layers[0].tint = {0, 255, 0};
    view.layers.insert(view.layers.begin(), above);
    view.eyeDomeLighting = false;
    const ShownView shown(view);
    LoupePicture loupe;
    const QColor middle = loupe.draw(shown.view, shown.seen(kFar), 6, 120).pixelColor(60, 60);
    EXPECT_GT(middle.red(), 200);
    EXPECT_LT(middle.green(), 60);
}

TEST(LoupePicture, CostsLittleHoweverManyPointsLieThere) {
    // A million points in 400 x 300 pixels, seen so that the loupe holds thousands, and from so far that it
    // holds all.
    ShownView shown(plainView(test::flatSquare(1000), NamedView::perspective));
    LoupePicture loupe;
    const QPointF middle(200, 150);
    loupe.draw(shown.view, middle, 6, 136);
    ViewCamera far = shown.view.camera();
    for (const double away : {0.0, 500.0}) {
        ViewCamera camera = far;
        camera.position -= away * camera.direction();
        shown.view.setCamera(camera);
        const double before = cpuSeconds();
        loupe.draw(shown.view, middle, 6, 136);
        EXPECT_LT(cpuSeconds() - before, 0.05) << away;
    }
}

}  // namespace
}  // namespace vestige
