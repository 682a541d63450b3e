#include "core/geometry/CameraProjection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace vestige;

namespace {

const BoundingBox kBox{{483000, 4375000, 30}, {483040, 4375020, 38}};

ViewCamera oblique() {
    return fitCamera(kBox, NamedView::perspective, 900, 600);
}

}  // namespace

TEST(CameraProjection, KeepsWhatLiesAtTheFocalPointsDepth) {
    const ViewCamera from = oblique();
    const ViewCamera flat = withProjection(from, true);
    ASSERT_TRUE(flat.parallel);
    const Eigen::Vector3d right = from.direction().cross(from.viewUp).normalized();
    for (const double aside : {-8.0, 0.0, 5.0}) {
        const Eigen::Vector3d place = from.focalPoint + aside * right;
        EXPECT_NEAR((from.project(place)->pixel - flat.project(place)->pixel).norm(), 0, 1e-6);
    }
    const ViewCamera back = withProjection(flat, false);
    EXPECT_NEAR((back.position - from.position).norm(), 0, 1e-6);
    EXPECT_FALSE(back.parallel);
}

TEST(CameraProjection, LooksFromTheOtherSide) {
    const ViewCamera front = fitCamera(kBox, NamedView::front, 900, 600);
    const ViewCamera back = fitCamera(kBox, NamedView::back, 900, 600);
    EXPECT_NEAR((back.direction() + front.direction()).norm(), 0, 1e-12);
    EXPECT_NEAR((back.viewUp - front.viewUp).norm(), 0, 1e-12);
    const ViewCamera top = fitCamera(kBox, NamedView::top, 900, 600);
    const ViewCamera bottom = fitCamera(kBox, NamedView::bottom, 900, 600);
    EXPECT_NEAR((bottom.direction() - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-12);
    // x keeps running to the right.
    EXPECT_NEAR(bottom.project(bottom.focalPoint + Eigen::Vector3d::UnitX())->pixel.x(),
                top.project(top.focalPoint + Eigen::Vector3d::UnitX())->pixel.x(), 1e-6);
    const ViewCamera left = fitCamera(kBox, NamedView::left, 900, 600);
    const ViewCamera right = fitCamera(kBox, NamedView::right, 900, 600);
    EXPECT_NEAR((right.direction() + left.direction()).norm(), 0, 1e-12);
    EXPECT_TRUE(back.parallel && right.parallel && bottom.parallel);
    for (const char* side : {"back", "right", "bottom"}) EXPECT_EQ(name(*namedViewFromName(side)), side);
}

TEST(CameraProjection, LeavesRoomAboveAtTheSameScale) {
    for (const bool parallel : {false, true}) {
        const ViewCamera from = withProjection(oblique(), parallel);
        const ViewCamera to = withRoomAbove(from, 80);
        EXPECT_EQ(to.height_px, from.height_px + 80);
        const Eigen::Vector3d right = from.direction().cross(from.viewUp).normalized();
        const Eigen::Vector3d up = right.cross(from.direction());
        for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, -2.0), std::pair(-3.0, 1.5)}) {
            const Eigen::Vector3d place = from.focalPoint + x * right + y * up;
            const Eigen::Vector2d moved = to.project(place)->pixel - from.project(place)->pixel;
            EXPECT_NEAR((moved - Eigen::Vector2d(0, 80)).norm(), 0, 1e-6);
        }
    }
}

TEST(CameraProjection, ShowsAllOfItInAPictureOfAnotherShape) {
    for (const bool parallel : {false, true}) {
        const ViewCamera from = withProjection(oblique(), parallel);
        for (const auto& [width, height] : {std::pair(300, 900), std::pair(2000, 500), std::pair(900, 600)}) {
            const ViewCamera to = resized(from, width, height);
            for (const double x : {0.0, 900.0})
                for (const double y : {0.0, 600.0}) {
                    const ViewRay ray = from.ray({x, y});
                    const Eigen::Vector3d corner = ray.from + 30 * ray.direction;
                    const Eigen::Vector2d pixel = to.project(corner)->pixel;
                    EXPECT_GE(pixel.x(), -1e-6);
                    EXPECT_LE(pixel.x(), width + 1e-6);
                    EXPECT_GE(pixel.y(), -1e-6);
                    EXPECT_LE(pixel.y(), height + 1e-6);
                }
        }
    }
}
