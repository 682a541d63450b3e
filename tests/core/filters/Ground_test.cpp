#include "core/filters/Ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/filters/CleaningParameters.h"
#include "core/filters/Objects.h"
#include "tests/core/filters/FilterClouds.h"

using namespace vestige;

namespace {

const Eigen::Vector3d kSite(518440, 4326120, 3);
constexpr double kNoise_m = 0.02;

/// A hill road of slope 0.08 with a hump; what a plumb line finds at x, y.
double trueHeight(double x, double y) {
    return 0.08 * x + 0.3 * std::sin(0.15 * y);
}

struct Site {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> thing;  ///< 0 ground, 1 car, 2 pole, 3 carton, 4 house
};

/// Points on the ground outside of what stands on it, and on the upper sides of that.
Site site() {
    Site all;
    Random random(11);
    struct Block {
        double x, y, length, width, height;
        int thing;
    };
    const std::vector<Block> blocks{{4, 3, 4.6, 1.8, 1.5, 1},
                                    {-8, -6, 0.2, 0.2, 5, 2},
                                    {0, -4, 0.6, 0.4, 0.5, 3},
                                    {-16, 14, 12, 8, 7, 4}};
    for (int i = 0; i < 160000; ++i) {
        const double x = random.uniform(-25, 25), y = random.uniform(-25, 25);
        const bool covered = std::any_of(blocks.begin(), blocks.end(), [&](const Block& b) {
            return std::abs(x - b.x) < b.length / 2 && std::abs(y - b.y) < b.width / 2;
        });
        if (covered) continue;
        all.points.emplace_back(x, y, trueHeight(x, y) + kNoise_m * random.normal());
        all.thing.push_back(0);
    }
    for (const Block& b : blocks)
        for (int i = 0; i < 3000; ++i) {
            double x = random.uniform(-0.5, 0.5) * b.length, y = random.uniform(-0.5, 0.5) * b.width;
            double z = b.height;
            if (i % 3 > 0) {
                z = random.uniform(0.12, b.height);
                (i % 3 == 1 ? x : y) = (i % 2 ? 0.5 : -0.5) * (i % 3 == 1 ? b.length : b.width);
            }
            all.points.emplace_back(b.x + x, b.y + y, trueHeight(b.x, b.y) + z + kNoise_m * random.normal());
            all.thing.push_back(b.thing);
        }
    for (int i = 0; i < 20; ++i) {  // echoes from beneath the road
        all.points.emplace_back(random.uniform(-20, 20), random.uniform(-20, 20), -6 - random.uniform());
        all.thing.push_back(5);
    }
    for (Eigen::Vector3d& point : all.points) point += kSite;
    return all;
}

}  // namespace

TEST(Ground, IsFoundOnAHillUnderACarAHouseAndStrays) {
    const Site truth = site();
    const PointCloud cloud = test::cloudOf(truth.points, kSite);
    const UprightPoints points(cloud, {});
    const auto ground = findGround(points, {});
    ASSERT_TRUE(ground);
    std::size_t onGround = 0, found = 0, false_ = 0, things = 0;
    double squares = 0;
    std::vector<std::uint8_t> is(cloud.size(), 0);
    for (const std::uint32_t point : groundPoints(points, *ground)) is[point] = 1;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (truth.thing[i] == 0) {
            ++onGround;
            found += is[i];
            const Eigen::Vector3d place = truth.points[i] - kSite;
            const double height = place.z() - trueHeight(place.x(), place.y());
            squares += std::pow(static_cast<double>(ground->heightAbove(points[i])) - height, 2);
        } else {
            // The house stands in the slope; its foot is no higher than the ground beside it.
            const Eigen::Vector3d place = truth.points[i] - kSite;
            if (std::abs(place.z() - trueHeight(place.x(), place.y())) < 0.15) continue;
            ++things;
            false_ += is[i];
        }
    }
    EXPECT_GT(static_cast<double>(found), 0.985 * static_cast<double>(onGround));
    EXPECT_LT(static_cast<double>(false_), 0.002 * static_cast<double>(things));
    EXPECT_LT(std::sqrt(squares / static_cast<double>(onGround)), 0.010) << "half of the noise";
}

TEST(Ground, DoesNotDependOnThreadsOrWhereAndHowTheCloudLies) {
    const Site truth = site();
    const PointCloud cloud = test::cloudOf(truth.points, kSite);
    setThreadCount(1);
    const UprightPoints points(cloud, {});
    const auto one = groundPoints(points, *findGround(points, {}));
    setThreadCount(5);
    EXPECT_EQ(groundPoints(points, *findGround(points, {})), one);
    setThreadCount(0);
    // The same cloud in millimetres, tilted; the layer's place says how it stands.
    Similarity up;
    up.scale = 0.001;
    up.pose = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0).normalized()) * Pose::Identity();
    std::vector<Eigen::Vector3d> tilted;
    for (const Eigen::Vector3d& point : truth.points) tilted.push_back(up.inverse() * (point - kSite));
    const PointCloud other = test::cloudOf(tilted);
    const UprightPoints again(other, up);
    const auto same = groundPoints(again, *findGround(again, {}));
    EXPECT_NEAR(static_cast<double>(same.size()), static_cast<double>(one.size()),
                0.002 * static_cast<double>(one.size()));
}

TEST(Ground, RefusesWhatHasNoAnswer) {
    const PointCloud none;
    EXPECT_FALSE(findGround(UprightPoints(none, {}), {}));
    const PointCloud far = test::cloudOf({{0, 0, 0}, {1e6, 1e6, 0}});
    const auto refused = findGround(UprightPoints(far, {}), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    const PointCloud single = test::cloudOf({{1, 2, 3}});
    const auto flat = findGround(UprightPoints(single, {}), {});
    ASSERT_TRUE(flat);
    EXPECT_EQ(groundPoints(UprightPoints(single, {}), *flat).size(), 1U);
}

TEST(GroundGrid, OpeningIsTheGreatestOfTheLeast) {
    Random random(4);
    const int columns = 23, rows = 17;
    std::vector<float> heights(columns * rows);
    for (float& height : heights)
        height = random.uniform() < 0.15 ? std::numeric_limits<float>::quiet_NaN()
                                         : static_cast<float>(random.uniform());
    for (const int radius : {1, 2, 5, 30}) {
        const auto extreme = [&](const std::vector<float>& of, bool least) {
            std::vector<float> result(of.size(), std::numeric_limits<float>::quiet_NaN());
            for (int y = 0; y < rows; ++y)
                for (int x = 0; x < columns; ++x)
                    for (int v = std::max(0, y - radius); v <= std::min(rows - 1, y + radius); ++v)
                        for (int u = std::max(0, x - radius); u <= std::min(columns - 1, x + radius); ++u) {
                            const float h = of[v * columns + u];
                            float& r = result[y * columns + x];
                            if (!std::isnan(h) && (std::isnan(r) || (least ? h < r : h > r))) r = h;
                        }
            return result;
        };
        const auto expected = extreme(extreme(heights, true), false);
        std::vector<float> opened = heights;
        openHeights(opened, columns, rows, radius);
        for (std::size_t i = 0; i < heights.size(); ++i) {
            if (std::isnan(heights[i]))
                EXPECT_TRUE(std::isnan(opened[i]));
            else
                ASSERT_EQ(opened[i], expected[i]) << radius << " at " << i;
        }
    }
    fillHeights(heights, columns, rows);
    for (const float height : heights) EXPECT_TRUE(height >= 0 && height <= 1);
}

TEST(Objects, AreSeparatedNamedAndMeasured) {
    const Site truth = site();
    const PointCloud cloud = test::cloudOf(truth.points, kSite);
    const UprightPoints points(cloud, {});
    const auto ground = findGround(points, {});
    ASSERT_TRUE(ground);
    const auto found = findObjects(points, *ground, {});
    ASSERT_TRUE(found);
    const auto of = [&](int thing) -> const FoundObject* {
        for (const FoundObject& object : *found)
            if (std::count_if(object.points.begin(), object.points.end(),
                              [&](std::uint32_t point) { return truth.thing[point] == thing; }) > 1500)
                return &object;
        return nullptr;
    };
    ASSERT_TRUE(of(1) && of(2) && of(3));
    EXPECT_EQ(of(1)->kind, "vehicle");
    EXPECT_NEAR(of(1)->box.length_m, 4.6, 0.15);
    EXPECT_NEAR(of(1)->box.width_m, 1.8, 0.15);
    EXPECT_NEAR(of(1)->box.height_m, 1.4, 0.2);
    EXPECT_EQ(of(2)->kind, "vegetation");
    EXPECT_EQ(of(3)->kind, "debris");
    EXPECT_NEAR(of(3)->box.length_m, 0.6, 0.15);
    for (const FoundObject& object : *found) {
        EXPECT_TRUE(std::is_sorted(object.points.begin(), object.points.end()));
        EXPECT_GE(object.points.size(), 40U);
    }
    ObjectOptions few;
    few.largest_m = 3;
    const auto small = findObjects(points, *ground, few);
    ASSERT_TRUE(small);
    EXPECT_LT(small->size(), found->size());
    for (const FoundObject& object : *small) EXPECT_LE(object.box.length_m, 3);
}

TEST(UprightBox, TurnsWithWhatItHolds) {
    Random random(9);
    for (const double turn : {0.0, 0.3, 1.2, 2.9}) {
        std::vector<Eigen::Vector3f> points;
        for (int i = 0; i < 4000; ++i) {
            const Eigen::Vector2d flat =
                Eigen::Rotation2Dd(turn) * Eigen::Vector2d(random.uniform(-2, 2), random.uniform(-0.5, 0.5));
            points.emplace_back(static_cast<float>(flat.x()), static_cast<float>(flat.y()),
                                static_cast<float>(random.uniform(1, 2.5)));
        }
        const UprightBox box = uprightBox(points);
        EXPECT_NEAR(box.length_m, 4, 0.05);
        EXPECT_NEAR(box.width_m, 1, 0.05);
        EXPECT_NEAR(box.height_m, 1.5, 0.02);
        EXPECT_NEAR(box.bottom_m, 1, 0.02);
    }
    const std::vector<Eigen::Vector3f> line{{0, 0, 0}, {3, 4, 1}};
    EXPECT_NEAR(uprightBox(line).length_m, 5, 1e-6);
    EXPECT_EQ(uprightBox({}).length_m, 0);
}

TEST(Outliers, FoundAreTheOnesThatRemovingLeavesOut) {
    const PointCloud cloud = test::cloudOf(test::roughScene(4000, Eigen::Vector3d::Zero()));
    for (const char* method : {"distance", "number"}) {
        ParameterSet parameters(outlierSearchParameters());
        ASSERT_TRUE(parameters.set("method", std::string(method)));
        ASSERT_TRUE(parameters.set("fewest", std::int64_t{12}));
        ASSERT_TRUE(parameters.set("sigmas", 1.0));
        const OutlierOptions options = outlierOptions(parameters, 1);
        const auto found = findOutliers(cloud, options);
        ASSERT_TRUE(found);
        EXPECT_GT(found->size(), 20U);
        EXPECT_EQ(removeOutliers(cloud, options)->size() + found->size(), cloud.size());
        EXPECT_TRUE(std::is_sorted(found->begin(), found->end()));
    }
    EXPECT_EQ(describe(ParameterSet(outlierSearchParameters())).find("Judge a point by: distance; "), 0U);
}
