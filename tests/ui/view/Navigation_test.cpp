#include "ui/view/Navigation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vestige;

namespace {

const BoundingBox kBox{{483000, 4375000, 30}, {483100, 4375080, 45}};
const Eigen::Vector3d kPoint{483020, 4375070, 31};
constexpr NamedView kViews[] = {NamedView::perspective, NamedView::top, NamedView::front, NamedView::left,
                                NamedView::iso};

Eigen::Vector2d pixelOf(const ViewCamera& camera, const Eigen::Vector3d& world) {
    return camera.project(world).value().pixel;
}

}  // namespace

TEST(Navigation, OrbitKeepsThePivotInPlaceAndTheHorizonLevel) {
    for (const NamedView view : kViews) {
        ViewCamera camera = fitCamera(kBox, view, 1400, 900);
        const Eigen::Vector2d before = pixelOf(camera, kPoint);
        const Eigen::Vector3d direction = camera.direction();
        for (const Eigen::Vector2d& drag : {Eigen::Vector2d(40, 25), Eigen::Vector2d(-130, -90)})
            camera = orbited(camera, kPoint, drag);
        EXPECT_LT((pixelOf(camera, kPoint) - before).norm(), 1e-5) << name(view);
        EXPECT_GT((camera.direction() - direction).norm(), 0.3) << name(view);
        EXPECT_NEAR(camera.direction().cross(camera.viewUp).z(), 0, 1e-9) << name(view);
        EXPECT_GE(camera.viewUp.z(), -1e-9) << name(view);
    }
}

TEST(Navigation, OrbitStopsStraightAboveAndBelow) {
    ViewCamera camera = fitCamera(kBox, NamedView::iso, 1400, 900);
    for (int i = 0; i < 20; ++i) camera = orbited(camera, kPoint, {0, 100});
    EXPECT_NEAR(camera.direction().z(), -1, 1e-9);
    for (int i = 0; i < 20; ++i) camera = orbited(camera, kPoint, {0, -100});
    EXPECT_NEAR(camera.direction().z(), 1, 1e-9);
}

TEST(Navigation, PanMovesThePointUnderTheCursorWithIt) {
    for (const NamedView view : kViews) {
        const ViewCamera camera = fitCamera(kBox, view, 1400, 900);
        const double depth = camera.project(kPoint)->depth_m;
        const Eigen::Vector2d moved =
            pixelOf(panned(camera, depth, {37, -12}), kPoint) - pixelOf(camera, kPoint);
        EXPECT_LT((moved - Eigen::Vector2d(37, -12)).norm(), 1e-5) << name(view);
    }
}

TEST(Navigation, ZoomGoesToThePivot) {
    for (const NamedView view : kViews) {
        const ViewCamera camera = fitCamera(kBox, view, 1400, 900);
        const ViewCamera nearer = zoomed(camera, kPoint, 0.5);
        EXPECT_LT((pixelOf(nearer, kPoint) - pixelOf(camera, kPoint)).norm(), 1e-5) << name(view);
        const double before = camera.metresPerPixel(camera.project(kPoint)->depth_m);
        const double after = nearer.metresPerPixel(nearer.project(kPoint)->depth_m);
        EXPECT_NEAR(after / before, 0.5, 1e-9) << name(view);
    }
}

TEST(Navigation, ZoomNeverPassesThePivot) {
    ViewCamera camera = fitCamera(kBox, NamedView::perspective, 1400, 900);
    for (int i = 0; i < 200; ++i) camera = zoomed(camera, kPoint, 0.7);
    ASSERT_TRUE(camera.project(kPoint));
    EXPECT_GT(camera.project(kPoint)->depth_m, 0.009);
}
