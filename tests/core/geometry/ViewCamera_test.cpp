#include "core/geometry/ViewCamera.h"

#include <gtest/gtest.h>

using namespace vestige;

TEST(ViewCamera, RayGoesThroughTheProjectedPoint) {
    const BoundingBox box{{483000, 4375000, 30}, {483100, 4375080, 45}};
    for (const NamedView view :
         {NamedView::perspective, NamedView::top, NamedView::front, NamedView::left, NamedView::iso}) {
        const ViewCamera camera = fitCamera(box, view, 1400, 900);
        const Eigen::Vector3d world(483020, 4375070, 31);
        const auto seen = camera.project(world);
        ASSERT_TRUE(seen);
        const ViewRay ray = camera.ray(seen->pixel);
        EXPECT_LT((world - ray.from).cross(ray.direction).norm(), 1e-6) << name(view);
    }
}

TEST(ViewCamera, FittedBoxFillsThePicture) {
    const BoundingBox box{{0, 0, 0}, {10, 6, 3}};
    for (const NamedView view :
         {NamedView::perspective, NamedView::top, NamedView::front, NamedView::left, NamedView::iso}) {
        const ViewCamera camera = fitCamera(box, view, 800, 500);
        double widest = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const auto seen = camera.project(
                {(corner & 1) ? 10.0 : 0.0, (corner & 2) ? 6.0 : 0.0, (corner & 4) ? 3.0 : 0.0});
            ASSERT_TRUE(seen);
            EXPECT_TRUE(seen->pixel.x() >= 0 && seen->pixel.x() <= 800 && seen->pixel.y() >= 0 &&
                        seen->pixel.y() <= 500);
            widest = std::max(
                {widest, std::abs(seen->pixel.x() - 400) / 400, std::abs(seen->pixel.y() - 250) / 250});
        }
        EXPECT_GT(widest, 0.85) << name(view);
    }
}
