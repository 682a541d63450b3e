#include "core/geometry/SectionSlab.h"

#include <gtest/gtest.h>

#include "core/base/Random.h"

using namespace vestige;

namespace {

const BoundingBox kScene{{10, 20, 0}, {30, 60, 8}};

ViewCamera along(const Eigen::Vector3d& direction) {
    ViewCamera camera;
    camera.focalPoint = kScene.centre();
    camera.position = camera.focalPoint - 50 * direction.normalized();
    camera.viewUp =
        std::abs(direction.normalized().z()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    return camera;
}

}  // namespace

TEST(SectionSlab, RoundTheSceneHoldsAllOfIt) {
    const SectionBox box = sectionRound(kScene);
    EXPECT_TRUE(box.contains(kScene.min));
    EXPECT_TRUE(box.contains(kScene.max));
    EXPECT_FALSE(box.contains(kScene.max + Eigen::Vector3d(1, 0, 0)));
    EXPECT_TRUE(sectionRound({}).contains({0, 0, 0}));
}

TEST(SectionSlab, IsThinAlongItsAxis) {
    const SlabAxis axes[] = {SlabAxis::x, SlabAxis::y, SlabAxis::z};
    for (int axis = 0; axis < 3; ++axis) {
        const SectionBox cut = slab(kScene, axes[axis], 0.2, along({0, 1, 0}));
        EXPECT_EQ(thinAxis(cut), axis);
        Eigen::Vector3d aside = Eigen::Vector3d::Zero();
        aside[axis] = 0.09;
        EXPECT_TRUE(cut.contains(kScene.centre() + aside));
        aside[axis] = 0.11;
        EXPECT_FALSE(cut.contains(kScene.centre() + aside));
    }
}

TEST(SectionSlab, FacesTheView) {
    const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, -0.5).normalized();
    const SectionBox cut = slab(kScene, SlabAxis::view, 0.2, along(direction));
    const Eigen::Vector3d level = Eigen::Vector3d(direction.x(), direction.y(), 0).normalized();
    EXPECT_NEAR(std::abs(axisOf(cut, thinAxis(cut)).dot(level)), 1, 1e-12);
    const SectionBox flat = slab(kScene, SlabAxis::view, 0.2, along({0, 0.1, -1}));
    EXPECT_EQ(thinAxis(flat), 2);
}

/// A face that is dragged leaves the other five where they are.
TEST(SectionSlab, AFaceMovesAlone) {
    Random random(3, 0);
    for (int round = 0; round < 50; ++round) {
        SectionBox box = sectionRound(kScene);
        box.heading_rad = 6 * random.uniform();
        const int axis = static_cast<int>(random.below(3));
        const int side = random.below(2) ? 1 : -1;
        const double by = 4 * random.uniform() - 1;
        const SectionBox after = withFaceMoved(box, axis, side, by);
        const Eigen::Vector3d out = side * axisOf(box, axis);
        EXPECT_NEAR(out.dot(after.centre) + after.halfSize[axis],
                    out.dot(box.centre) + box.halfSize[axis] + by, 1e-9);
        EXPECT_NEAR(out.dot(after.centre) - after.halfSize[axis], out.dot(box.centre) - box.halfSize[axis],
                    1e-9);
    }
    const SectionBox thin = withFaceMoved(sectionRound(kScene), 0, 1, -1000);
    EXPECT_GT(thin.halfSize.x(), 0);
}
