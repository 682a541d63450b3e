#include "core/registration/quality/FreeSpace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"

namespace vestige {
namespace {

constexpr double kCell_m = 0.2;

/// Distance along the ray to the walls of a room of 12 x 8 x 3 m, or to a pillar in it.
double distanceAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
    double walls = 1e9;
    const Eigen::Vector3d half(6, 4, 1.5);
    for (int axis = 0; axis < 3; ++axis)
        walls = std::min(walls, ((ray[axis] < 0 ? -half[axis] : half[axis]) - from[axis]) / ray[axis]);
    double near = 0, far = walls;
    for (int axis = 0; axis < 2; ++axis) {
        const double middle = axis == 0 ? 2.0 : 1.0;
        const double one = (middle - 0.4 - from[axis]) / ray[axis];
        const double two = (middle + 0.4 - from[axis]) / ray[axis];
        near = std::max(near, std::min(one, two));
        far = std::min(far, std::max(one, two));
    }
    return near < far ? near : walls;
}

/// Scanned from `eye`, in the room's frame.
std::vector<Eigen::Vector3f> scanFrom(const Eigen::Vector3d& eye, std::uint64_t seed) {
    Random random(seed);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 40000; ++i) {
        const double x = random.normal();
        const double y = random.normal();
        const double z = random.normal();
        const Eigen::Vector3d ray = Eigen::Vector3d(x, y, z).normalized();
        const double noise = random.normal(0, 0.003);
        points.push_back((eye + (distanceAlong(eye, ray) + noise) * ray).cast<float>());
    }
    return points;
}

/// One point per 5 cm of what was scanned, as a fused cloud has it.
std::vector<Eigen::Vector3f> fused(const std::vector<Eigen::Vector3f>& points) {
    std::vector<Eigen::Vector3f> kept;
    for (const Eigen::Vector3f& point : points)
        if (std::none_of(kept.begin(), kept.end(),
                         [&](const Eigen::Vector3f& one) { return (one - point).norm() < 0.12F; }))
            kept.push_back(point);
    return kept;
}

struct Scan {
    Eigen::Vector3d eye;
    std::vector<Eigen::Vector3f> points;
    std::vector<SurfaceCell> cells = surfaceCells(points, kCell_m, 4);

    Sighted sighted() const { return {points, cells, eye}; }
};

const Eigen::Vector3d kFirst(-3, -1, 0);
const Eigen::Vector3d kSecond(0.5, -2, 0.1);

}  // namespace

TEST(FreeSpace, NothingIsSeenThroughAtTheRightPose) {
    const Scan target{kFirst, scanFrom(kFirst, 1)}, source{kSecond, scanFrom(kSecond, 2)};
    const FreeSpace space(target.sighted(), source.sighted(), 0.05, 8 * kCell_m);
    for (const auto& shares : {space.fromTarget(Pose::Identity()), space.fromSource(Pose::Identity())}) {
        ASSERT_TRUE(shares);
        EXPECT_GT(shares->cells, 100U);
        EXPECT_LT(shares->through(), 0.002);
    }
}

TEST(FreeSpace, APillarIsSeenThroughWhereTheRoomIsTurnedByHalf) {
    const Scan target{kFirst, scanFrom(kFirst, 1)}, source{kSecond, scanFrom(kSecond, 2)};
    const FreeSpace space(target.sighted(), source.sighted(), 0.05, 8 * kCell_m);
    Pose half = Pose::Identity();
    half.linear() = Eigen::Vector3d(-1, -1, 1).asDiagonal();
    EXPECT_GT(space.through(half), 0.01);  // walls, floor and ceiling agree
    EXPECT_LT(space.through(half), 0.2);
}

TEST(FreeSpace, SaysNothingWhereTheViewpointIsNotBorneOut) {
    const std::vector<Eigen::Vector3f> points = scanFrom(kFirst, 1);
    const Scan good{kFirst, points};
    const auto believes = [&](const Scan& scan) {
        return FreeSpace(scan.sighted(), good.sighted(), 0.05, 8 * kCell_m)
            .fromTarget(Pose::Identity())
            .has_value();
    };
    EXPECT_TRUE(believes(good));
    EXPECT_FALSE(believes({Eigen::Vector3d(20, 0, 0), points}));     // outside
    EXPECT_FALSE(believes({Eigen::Vector3d(4.5, 2, 0.2), points}));  // behind the pillar
    EXPECT_FALSE(believes({kFirst, fused(points)}));
}

}  // namespace vestige
