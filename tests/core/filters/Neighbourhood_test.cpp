#include "core/filters/Neighbourhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "core/base/Parallel.h"
#include "core/filters/Spacing.h"
#include "tests/core/filters/FilterClouds.h"

using namespace vestige;
using namespace vestige::test;

namespace {

constexpr NeighbourhoodFilter kFilters[] = {NeighbourhoodFilter::mean, NeighbourhoodFilter::median,
                                            NeighbourhoodFilter::gaussian};

double middleOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The definition of METHOD section 2, in double, over all points.
Eigen::Vector3d reference(const std::vector<Eigen::Vector3d>& points, std::size_t i, double radius,
                          NeighbourhoodFilter filter) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0;
    std::vector<double> axes[3];
    for (const Eigen::Vector3d& other : points) {
        const double squared = (other - points[i]).squaredNorm();
        if (squared > radius * radius) continue;
        const double weight =
            filter == NeighbourhoodFilter::gaussian ? std::exp(-squared / (2 * 0.25 * radius * radius)) : 1;
        weights += weight;
        sum += weight * (other - points[i]);
        for (int axis = 0; axis < 3; ++axis) axes[axis].push_back(other[axis]);
    }
    if (filter == NeighbourhoodFilter::median)
        return {middleOf(axes[0]), middleOf(axes[1]), middleOf(axes[2])};
    return points[i] + sum / weights;
}

}  // namespace

TEST(Neighbourhood, AgreesWithTheDefinition) {
    const Eigen::Vector3d middle(483400, 4375661, 35);
    const auto points = roughScene(3000, middle);
    const PointCloud cloud = cloudOf(points, middle);
    // A radius off the points' lattice, so that no distance equals it.
    const double radius = 0.14701;
    for (const NeighbourhoodFilter filter : kFilters) {
        const auto filtered = filterNeighbourhood(cloud, {filter, radius});
        ASSERT_TRUE(filtered);
        ASSERT_EQ(filtered->size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_LT((filtered->point(i) - reference(points, i, radius, filter)).norm(), 1e-6) << i;
    }
}

TEST(Neighbourhood, ReducesTheNoiseOfAPlaneAndLeavesItInPlace) {
    Random random(4);
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 120; ++x)
        for (int y = 0; y < 120; ++y) points.emplace_back(0.05 * x, 0.05 * y, 0.03 * random.normal());
    const PointCloud cloud = cloudOf(points);
    for (const NeighbourhoodFilter filter : kFilters) {
        const auto filtered = filterNeighbourhood(cloud, {filter, 0.16});
        ASSERT_TRUE(filtered);
        double squares = 0;
        double sum = 0;
        for (std::size_t i = 0; i < filtered->size(); ++i) {
            squares += filtered->point(i).z() * filtered->point(i).z();
            sum += filtered->point(i).z();
        }
        const auto size = static_cast<double>(filtered->size());
        // Up to 32 neighbours: a mean of them would have 0.18 of a point's noise, a median 0.22; a bit more
        // stays, as the ball round a point that noise has lifted holds more of the lifted ones.
        EXPECT_LT(std::sqrt(squares / size), 0.35 * 0.03);
        EXPECT_GT(std::sqrt(squares / size), 0.1 * 0.03);
        EXPECT_NEAR(sum / size, 0, 0.001);
    }
}

TEST(Neighbourhood, KeepsAConstantField) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y) points.emplace_back(4e5 + 0.0625 * x, 5e6 + 0.0625 * y, 123.4375);
    const PointCloud cloud = cloudOf(points, {4e5, 5e6, 100});
    for (const NeighbourhoodFilter filter : kFilters) {
        const auto filtered = filterNeighbourhood(cloud, {filter, 0.13});
        ASSERT_TRUE(filtered);
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_EQ(filtered->point(i).z(), 123.4375);
            // Inside, neighbours are symmetric and a point stays where it is.
            const std::size_t x = i / 40;
            const std::size_t y = i % 40;
            if (x > 2 && x < 37 && y > 2 && y < 37) {
                ASSERT_LT((filtered->point(i) - points[i]).norm(), 1e-8);
            }
        }
    }
}

TEST(Neighbourhood, IsTheSameForAnyThreadsAndOrigin) {
    const Eigen::Vector3d middle(483400, 4375661, 35);
    const auto points = roughScene(40000, middle);
    const PointCloud cloud = cloudOf(points, middle);
    const PointCloud moved = cloudOf(points, middle + Eigen::Vector3d(64.5, -32.25, 8));
    for (const NeighbourhoodFilter filter : kFilters) {
        setThreadCount(1);
        const auto one = filterNeighbourhood(cloud, {filter, 0});
        ASSERT_TRUE(one);
        for (const int threads : {2, 7}) {
            setThreadCount(threads);
            expectIdentical(*one, *filterNeighbourhood(cloud, {filter, 0}));
        }
        setThreadCount(0);
        const auto elsewhere = filterNeighbourhood(moved, {filter, 0});
        ASSERT_TRUE(elsewhere);
        // The same sums; only the float offsets round differently.
        for (std::size_t i = 0; i < one->size(); ++i)
            ASSERT_LT((elsewhere->point(i) - one->point(i)).norm(), 1e-5);
    }
}

TEST(Neighbourhood, FarFromTheOriginNothingIsLost) {
    // Two patches 40 km apart in one cloud: float offsets alone would round to 2 mm.
    std::vector<Eigen::Vector3d> points;
    for (const double far : {0.0, 40000.0})
        for (int x = 0; x < 20; ++x)
            for (int y = 0; y < 20; ++y) points.emplace_back(far + 0.0078125 * x, 0.0078125 * y, 1);
    const PointCloud cloud = cloudOf(points);
    const auto filtered = filterNeighbourhood(cloud, {NeighbourhoodFilter::mean, 0.02});
    ASSERT_TRUE(filtered);
    for (std::size_t i = 0; i < 400; ++i)
        ASSERT_LT((filtered->point(400 + i) - filtered->point(i) - Eigen::Vector3d(40000, 0, 0)).norm(),
                  1e-6);
}

TEST(Neighbourhood, AFarStrayChangesNothingForTheRest) {
    auto points = roughScene(3000, {0, 0, 0});
    points.emplace_back(4e7, 0, 0);
    for (const NeighbourhoodFilter filter : kFilters) {
        const auto alongside = filterNeighbourhood(cloudOf(points), {filter, 0.14701});
        ASSERT_TRUE(alongside);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            ASSERT_LT((alongside->point(i) - reference(points, i, 0.14701, filter)).norm(), 1e-6);
        EXPECT_EQ(alongside->point(3000), points[3000]);
    }
}

TEST(Neighbourhood, ThousandsOfPointsInOnePlaceAreNoBurden) {
    auto points = roughScene(3000, {0, 0, 0});
    points.insert(points.end(), 300000, Eigen::Vector3d(50, 50, 0));
    const auto filtered = filterNeighbourhood(cloudOf(points), {NeighbourhoodFilter::mean, 0.1});
    ASSERT_TRUE(filtered);
    for (std::size_t i = 3000; i < points.size(); ++i) ASSERT_EQ(filtered->point(i), points[i]);
}

TEST(Neighbourhood, AutomaticRadiusIsThreeSpacings) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 100; ++x)
        for (int y = 0; y < 100; ++y) points.emplace_back(0.02 * x, 0.02 * y, 0);
    EXPECT_NEAR(automaticRadius(cloudOf(points)), 0.06, 1e-4);
    EXPECT_EQ(automaticRadius(cloudOf({{1, 2, 3}})), 0);
    // Nothing to average: the cloud stays.
    const auto single = filterNeighbourhood(cloudOf({{1, 2, 3}}), {});
    ASSERT_TRUE(single);
    EXPECT_EQ(single->point(0), Eigen::Vector3d(1, 2, 3));
    EXPECT_TRUE(filterNeighbourhood(PointCloud(), {NeighbourhoodFilter::median, 0.1})->empty());
    for (const double radius : {-1.0, std::nan(""), 1e12})
        EXPECT_EQ(filterNeighbourhood(cloudOf(points), {NeighbourhoodFilter::mean, radius}).error().code,
                  ErrorCode::usage);
}

TEST(Neighbourhood, ReportsProgressAndStopsWhenAsked) {
    const PointCloud cloud = cloudOf(roughScene(100000, {0, 0, 0}));
    std::atomic<double> last = 0;
    const JobControl watched(
        [&](double fraction, std::string_view) { last = std::max(last.load(), fraction); }, {});
    ASSERT_TRUE(filterNeighbourhood(cloud, {NeighbourhoodFilter::mean, 0.1}, watched));
    EXPECT_DOUBLE_EQ(last, 1);

    const JobControl* job = nullptr;
    const JobControl stopping(
        [&](double fraction, std::string_view) {
            if (fraction > 0.3) job->cancel();
        },
        {});
    job = &stopping;
    const auto stopped = filterNeighbourhood(cloud, {NeighbourhoodFilter::mean, 0.1}, stopping);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}
