#include "core/geometry/Picking.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <tuple>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"

using namespace vestige;

namespace {

const Eigen::Vector3d kSite(483400, 4375661, 35);

/// Two walls one behind the other, ground and some leaves between, about `side` metres wide.
std::shared_ptr<const Octree> scene(double side, double metresPerUnit, const Eigen::Vector3d& corner,
                                    std::uint64_t seed) {
    Random random(seed);
    PointCloudBuilder builder(corner / metresPerUnit);
    const auto add = [&](double x, double y, double z) {
        builder.add((corner + side * Eigen::Vector3d(x, y, z)) / metresPerUnit);
    };
    for (int i = 0; i < 6000; ++i) {
        add(random.uniform(), 0.4 + 0.002 * random.normal(), random.uniform(0, 0.3));
        add(random.uniform(), 0.6 + 0.002 * random.normal(), random.uniform(0, 0.5));
        add(random.uniform(), random.uniform(), 0.002 * random.normal());
        if (i % 10 == 0) add(random.uniform(), random.uniform(0.1, 0.5), random.uniform(0.2, 0.6));
    }
    return std::make_shared<const Octree>(std::make_shared<const PointCloud>(std::move(builder).build()));
}

struct Layers {
    std::shared_ptr<const Octree> wide = scene(20, 1, kSite, 1);
    std::shared_ptr<const Octree> fine = scene(3, 0.001, Eigen::Vector3d::Zero(), 2);
    std::vector<PickLayer> all;

    Layers() {
        Similarity placed;
        placed.scale = 0.001;
        placed.pose = Eigen::Translation3d(kSite + Eigen::Vector3d(6, 5, 0)) *
                      Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.1, 0.2, 1).normalized());
        all.push_back({4, fine.get(), placed});
        all.push_back({2, wide.get(), {}});
    }
};

/// The rule of pickPoint, said with two loops over every point.
std::optional<Pick> reference(std::span<const PickLayer> layers, const ViewCamera& camera,
                              const Eigen::Vector2d& cursor, const PickOptions& options) {
    std::vector<Pick> candidates;
    for (const PickLayer& layer : layers) {
        for (std::uint32_t i = 0; i < layer.octree->cloud().size(); ++i) {
            Pick pick{layer.layer, i, layer.worldFromLayer * layer.octree->cloud().point(i), 0, 0, 0};
            const auto seen = camera.project(pick.world);
            if (!seen || (seen->pixel - cursor).norm() > options.radius_px) continue;
            bool inside = true;
            for (const ClipPlane& clip : options.clips.planes)
                inside = inside && clip.normal.dot(pick.world) + clip.distance >= 0;
            if (inside == options.clips.inverted) continue;
            pick.depth_m = seen->depth_m;
            pick.cursorDistance_px = (seen->pixel - cursor).norm();
            pick.localSpacing_m =
                layer.worldFromLayer.scale * static_cast<double>(layer.octree->localSpacing(i));
            candidates.push_back(pick);
        }
    }
    std::optional<Pick> best;
    for (const Pick& pick : candidates) {
        bool hidden = false;
        for (const Pick& other : candidates)
            hidden =
                hidden || pick.depth_m > other.depth_m + options.hiddenBehindSpacings * other.localSpacing_m;
        const auto rank = [](const Pick& p) {
            return std::tuple(p.cursorDistance_px, p.depth_m, p.layer, p.point);
        };
        if (!hidden && (!best || rank(pick) < rank(*best))) best = pick;
    }
    return best;
}

ViewCamera viewOf(bool parallel, double distance) {
    ViewCamera camera;
    camera.parallel = parallel;
    camera.width_px = 640;
    camera.height_px = 480;
    camera.focalPoint = kSite + Eigen::Vector3d(9, 9, 2);
    camera.position = camera.focalPoint + distance * Eigen::Vector3d(0.2, -1, 0.4).normalized();
    camera.viewUp = {0, 0, 1};
    camera.halfHeight_m = 0.3 * distance;
    return camera;
}

}  // namespace

TEST(Picking, AgreesWithTheRuleSaidByBruteForce) {
    const Layers layers;
    Random random(21);
    int hits = 0;
    int deeper = 0;
    for (int trial = 0; trial < 240; ++trial) {
        const ViewCamera camera = viewOf(trial % 2, trial % 3 == 0 ? 6 : 25);
        PickOptions options;
        options.radius_px = trial % 7 == 0 ? 25 : 6;
        if (trial % 5 == 0) options.clips.planes.push_back({{0, 1, 0}, -(kSite.y() + 8.5)});
        options.clips.inverted = trial % 15 == 0;
        if (trial % 10 == 0) options.clips.planes.push_back({{-0.3, 0, -1}, 0.3 * kSite.x() + kSite.z() + 6});
        const Eigen::Vector2d cursor(random.uniform(-20, 660), random.uniform(100, 500));
        const auto expected = reference(layers.all, camera, cursor, options);
        const auto found = pickPoint(layers.all, camera, cursor, options);
        ASSERT_EQ(found.has_value(), expected.has_value()) << trial;
        if (!found) continue;
        ++hits;
        ASSERT_EQ(std::tuple(found->layer, found->point), std::tuple(expected->layer, expected->point))
            << trial;
        ASSERT_EQ(found->world, expected->world);
        ASSERT_EQ(found->depth_m, expected->depth_m);
        ASSERT_EQ(found->localSpacing_m, expected->localSpacing_m);
        ASSERT_EQ(found->cursorDistance_px, expected->cursorDistance_px);
        // How often the nearest to the cursor of all candidates would have been the wrong answer.
        PickOptions seeThrough = options;
        seeThrough.hiddenBehindSpacings = std::numeric_limits<double>::infinity();
        deeper += reference(layers.all, camera, cursor, seeThrough)->point != expected->point;
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(deeper, 10);
}

TEST(Picking, TakesTheFrontWallUntilItIsClipped) {
    const Layers layers;
    ViewCamera camera = viewOf(false, 20);
    camera.position = kSite + Eigen::Vector3d(14, -6, 3);
    camera.focalPoint = kSite + Eigen::Vector3d(14, 8, 3);
    const Eigen::Vector2d middle(320, 240);
    PickOptions options;
    options.radius_px = 12;
    const std::span<const PickLayer> wide(&layers.all[1], 1);
    const auto front = pickPoint(wide, camera, middle, options);
    ASSERT_TRUE(front);
    EXPECT_NEAR(front->world.y() - kSite.y(), 8, 0.2);
    options.clips.planes.push_back({{0, 1, 0}, -(kSite.y() + 9)});
    const auto behind = pickPoint(wide, camera, middle, options);
    ASSERT_TRUE(behind);
    EXPECT_NEAR(behind->world.y() - kSite.y(), 12, 0.2);
    options.clips.planes.push_back({{0, -1, 0}, kSite.y() + 10});
    EXPECT_FALSE(pickPoint(wide, camera, middle, options));
}

TEST(Picking, NothingWhereThereIsNothing) {
    const ViewCamera camera = viewOf(false, 20);
    EXPECT_FALSE(pickPoint({}, camera, {320, 240}));
    const Octree none(std::make_shared<const PointCloud>());
    const std::vector<PickLayer> layers{{0, &none, {}}, {1, nullptr, {}}};
    EXPECT_FALSE(pickPoint(layers, camera, {320, 240}));
    // Behind a perspective camera.
    const Layers full;
    ViewCamera away = camera;
    away.focalPoint = 2 * away.position - away.focalPoint;
    EXPECT_FALSE(pickPoint(full.all, away, {320, 240}));
}
