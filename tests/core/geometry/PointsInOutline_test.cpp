#include "core/geometry/PointsInOutline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/geometry/OutlineMask.h"
#include "core/geometry/PointCloudBuilder.h"

using namespace vestige;

namespace {

using Corners = std::vector<Eigen::Vector2d>;
const Eigen::Vector3d kSite(483400, 4375661, 35);

/// Even-odd rule for one place, said by counting the sides that a line to the right crosses.
bool within(const Corners& corners, const Eigen::Vector2d& place) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d& a = corners[i];
        const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
        if ((a.y() > place.y()) == (b.y() > place.y())) continue;
        const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (place.x() < x) inside = !inside;
    }
    return inside;
}

Corners star(const Eigen::Vector2d& middle, double reach, int tips) {
    Corners corners;
    for (int i = 0; i < 2 * tips; ++i) {
        const double angle = std::numbers::pi * i / tips + 0.1;
        corners.push_back(middle +
                          (i % 2 ? 0.4 : 1.0) * reach * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

/// A wall 10 m before the eye and one 12 m before it, ground between, in `metresPerUnit`.
std::shared_ptr<const Octree> walls(std::size_t count, double metresPerUnit, std::uint64_t seed) {
    Random random(seed);
    PointCloudBuilder builder(kSite / metresPerUnit);
    for (std::size_t i = 0; i < count; ++i) {
        Eigen::Vector3d place(random.uniform(-6, 6), random.uniform(0, 14), 0.01 * random.normal());
        if (i % 3 > 0)
            place = {place.x(), (i % 3 == 1 ? 10 : 12) + 0.01 * random.normal(), random.uniform(0, 4)};
        builder.add((kSite + place) / metresPerUnit);
    }
    return std::make_shared<const Octree>(std::make_shared<const PointCloud>(std::move(builder).build()));
}

ViewCamera camera(bool parallel) {
    ViewCamera camera;
    camera.position = kSite + Eigen::Vector3d(0.4, 0, 1.7);
    camera.focalPoint = kSite + Eigen::Vector3d(0, 10, 1.5);
    camera.viewUp = {0, 0, 1};
    camera.parallel = parallel;
    camera.halfHeight_m = 4;
    camera.verticalAngle_rad = 0.7;
    camera.width_px = 400;
    camera.height_px = 300;
    return camera;
}

struct Scene {
    std::shared_ptr<const Octree> metres = walls(30000, 1, 1);
    std::shared_ptr<const Octree> millimetres = walls(9000, 0.001, 2);
    std::vector<PickLayer> layers;
    Scene() {
        layers.push_back({0, metres.get(), {}});
        Similarity placed;
        placed.scale = 0.001;
        layers.push_back({1, millimetres.get(), placed});
    }
};

/// The rule said with one loop over every point; no depth limit.
std::vector<std::uint32_t> reference(const PickLayer& layer, const ViewCamera& view, const Corners& corners,
                                     const OutlineOptions& options) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < layer.octree->cloud().size(); ++i) {
        const Eigen::Vector3d world = layer.worldFromLayer * layer.octree->cloud().point(i);
        if (layer.hidden && (*layer.hidden)[i]) continue;
        const auto& planes = options.clips.planes;
        const bool kept = std::all_of(planes.begin(), planes.end(), [&](const ClipPlane& clip) {
            return clip.normal.dot(world) + clip.distance >= 0;
        });
        if (kept == options.clips.inverted) continue;
        const auto seen = view.project(world);
        bool inside = false;
        if (seen) {
            const Eigen::Vector2d pixel = seen->pixel.array().floor() + 0.5;
            const bool inPicture = (seen->pixel.array() >= 0).all() && seen->pixel.x() < view.width_px &&
                                   seen->pixel.y() < view.height_px;
            inside = inPicture && within(corners, pixel);
        }
        if (inside != options.outside) found.push_back(i);
    }
    return found;
}

/// Rounding puts a point or two in the pixel beside.
void expectNearlySame(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> different;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different));
    EXPECT_LE(different.size(), 2U) << a.size() << " and " << b.size();
    EXPECT_TRUE(std::is_sorted(a.begin(), a.end()));
}

}  // namespace

TEST(OutlineMask, IsTheEvenOddRuleAtPixelCentres) {
    for (const Corners& corners :
         {star({60, 40}, 35, 5), star({0, 0}, 50, 7), Corners{{3, 3}, {90, 3}, {3, 70}, {90, 70}},
          Corners{{-50, -50}, {200, -50}, {200, 200}, {-50, 200}}}) {
        const OutlineMask mask(corners, 100, 80);
        for (int y = 0; y < 80; ++y)
            for (int x = 0; x < 100; ++x)
                ASSERT_EQ(mask.contains(x + 0.3, y + 0.7), within(corners, {x + 0.5, y + 0.5}))
                    << x << ' ' << y;
    }
    EXPECT_TRUE(OutlineMask(Corners{{1, 1}, {50, 50}}, 100, 80).empty());
    EXPECT_TRUE(OutlineMask(Corners{}, 0, 0).empty());
}

TEST(OutlineMask, TellsOfRectanglesWhatTheirPixelsTell) {
    const Corners corners = star({60, 40}, 38, 6);
    const OutlineMask mask(corners, 100, 80);
    Random random(3);
    int whole = 0;
    for (int i = 0; i < 3000; ++i) {
        const Eigen::Vector2d least(random.uniform(-10, 100), random.uniform(-10, 80));
        const Eigen::Vector2d most = least + Eigen::Vector2d(random.uniform(0, 20), random.uniform(0, 20));
        int in = 0, out = 0;
        for (double y = std::floor(least.y()); y <= most.y(); ++y)
            for (double x = std::floor(least.x()); x <= most.x(); ++x) ++(mask.contains(x, y) ? in : out);
        const auto cover = mask.cover(least, most);
        ASSERT_EQ(cover, in == 0    ? OutlineMask::Cover::none
                         : out == 0 ? OutlineMask::Cover::all
                                    : OutlineMask::Cover::part)
            << least.transpose() << " to " << most.transpose();
        whole += cover == OutlineMask::Cover::all;
    }
    EXPECT_GT(whole, 50);
}

TEST(PointsInOutline, AreThoseWhosePixelsLieWithin) {
    Scene scene;
    std::vector<std::uint8_t> hidden(scene.metres->cloud().size(), 0);
    for (std::size_t i = 0; i < hidden.size(); i += 7) hidden[i] = 1;
    scene.layers[0].hidden = &hidden;
    for (const bool parallel : {false, true})
        for (const auto& [outside, inverted] : {std::pair(false, false), std::pair(true, false),
                                                std::pair(false, true), std::pair(true, true)}) {
            OutlineOptions options;
            options.outside = outside;
            options.clips.planes = {{Eigen::Vector3d(1, 0, 0), 1 - kSite.x()}};
            options.clips.inverted = inverted;
            const ViewCamera view = camera(parallel);
            const Corners corners = star({210, 150}, 120, 6);
            const auto found = pointsInOutline(scene.layers, view, corners, options);
            ASSERT_TRUE(found);
            ASSERT_EQ(found->points.size(), 2U);
            for (std::size_t layer = 0; layer < 2; ++layer) {
                expectNearlySame(found->points[layer],
                                 reference(scene.layers[layer], view, corners, options));
                EXPECT_GT(found->points[layer].size(), 150U);
            }
            EXPECT_FALSE(found->deepest_m);
        }
}

/// Said with two loops over what was found.
TEST(PointsInOutline, CountWhatLiesBehindWhatIsSeen) {
    Scene scene;
    for (const bool parallel : {false, true}) {
        const ViewCamera view = camera(parallel);
        OutlineOptions options;
        options.behind_m = 0.5;
        const auto found = pointsInOutline(scene.layers, view, star({210, 150}, 120, 6), options);
        ASSERT_TRUE(found);
        std::map<std::pair<int, int>, double> nearest;
        std::vector<std::pair<std::pair<int, int>, double>> all;
        for (std::size_t layer = 0; layer < 2; ++layer)
            for (const std::uint32_t i : found->points[layer]) {
                const auto seen = view.project(scene.layers[layer].worldFromLayer *
                                               scene.layers[layer].octree->cloud().point(i));
                const std::pair tile(static_cast<int>(seen->pixel.x()) / 4,
                                     static_cast<int>(seen->pixel.y()) / 4);
                const auto known = nearest.try_emplace(tile, seen->depth_m).first;
                known->second = std::min(known->second, seen->depth_m);
                all.emplace_back(tile, seen->depth_m);
            }
        const auto behind = std::count_if(all.begin(), all.end(), [&](const auto& point) {
            return point.second > nearest[point.first] + 0.5;
        });
        EXPECT_GT(behind, 200);
        EXPECT_NEAR(static_cast<double>(found->behind), static_cast<double>(behind), 3);
        options.outside = true;
        EXPECT_EQ(pointsInOutline(scene.layers, view, star({210, 150}, 120, 6), options)->behind, 0U);
    }
}

TEST(PointsInOutline, EndAtTheDepthBehindTheNearestSurface) {
    const Scene scene;
    OutlineOptions options;
    options.depth_m = 1.0;
    // High enough for the walls alone.
    const Corners corners{{150, 40}, {250, 40}, {250, 110}, {150, 110}};
    const auto found = pointsInOutline(scene.layers, camera(false), corners, options);
    ASSERT_TRUE(found);
    ASSERT_TRUE(found->nearest_m && found->deepest_m);
    EXPECT_NEAR(*found->nearest_m, 10, 0.12);
    EXPECT_DOUBLE_EQ(*found->deepest_m, *found->nearest_m + 1);
    ASSERT_GT(found->points[0].size(), 300U);
    for (const std::uint32_t point : found->points[0])
        EXPECT_LT(scene.metres->cloud().point(point).y() - kSite.y(), 11);
    options.depth_m = 3.0;
    const auto both = pointsInOutline(scene.layers, camera(false), corners, options);
    EXPECT_GT(both->points[0].size(), 3 * found->points[0].size() / 2) << "the wall behind comes in";
}

TEST(PointsInOutline, AStrayBeforeTheSurfaceDoesNotStandForIt) {
    PointCloudBuilder builder(kSite);
    Random random(5);
    for (int i = 0; i < 40000; ++i)
        builder.add(kSite + Eigen::Vector3d(random.uniform(-3, 3), 10, random.uniform(0, 4)));
    builder.add(kSite + Eigen::Vector3d(0.2, 4, 1.6));
    const Octree octree(std::make_shared<const PointCloud>(std::move(builder).build()));
    const std::vector<PickLayer> layers{{0, &octree, {}}};
    OutlineOptions options;
    options.depth_m = 0.5;
    const Corners corners{{100, 50}, {300, 50}, {300, 250}, {100, 250}};
    const auto found = pointsInOutline(layers, camera(false), corners, options);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found->nearest_m, 10, 0.3);
    EXPECT_GT(found->points[0].size(), 5000U);
    EXPECT_EQ(found->points[0].back(), 40000U) << "the stray lies nearer and is taken, too";
}

TEST(PointsInOutline, AreTheSameForAnyNumberOfThreads) {
    const Scene scene;
    OutlineOptions options;
    options.depth_m = 0.8;
    const Corners corners = star({200, 150}, 140, 9);
    setThreadCount(1);
    const auto one = pointsInOutline(scene.layers, camera(false), corners, options);
    setThreadCount(7);
    const auto seven = pointsInOutline(scene.layers, camera(false), corners, options);
    setThreadCount(0);
    EXPECT_EQ(one->points, seven->points);
    EXPECT_EQ(one->nearest_m, seven->nearest_m);
}

TEST(PointsInOutline, RefuseADepthOfNothingAndStopWhenCancelled) {
    const Scene scene;
    OutlineOptions options;
    options.depth_m = 0;
    const auto refused = pointsInOutline(scene.layers, camera(false), star({200, 150}, 99, 4), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    const JobControl control;
    control.cancel();
    const auto stopped = pointsInOutline(scene.layers, camera(false), star({200, 150}, 99, 4), {}, control);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(Picking, PassesOverHiddenPoints) {
    Scene scene;
    const ViewCamera view = camera(false);
    const auto seen = pickPoint(scene.layers, view, {200, 100});
    ASSERT_TRUE(seen);
    std::vector<std::uint8_t> hidden(scene.layers[seen->layer].octree->cloud().size(), 0);
    hidden[seen->point] = 1;
    scene.layers[seen->layer].hidden = &hidden;
    const auto other = pickPoint(scene.layers, view, {200, 100});
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->layer == seen->layer && other->point == seen->point);
}
