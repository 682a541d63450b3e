#include "core/simulation/RayTracer.h"

#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "core/simulation/ModelBuilder.h"
#include "core/simulation/shapes/Shapes.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

/// Nearest face by trying every one, in double precision.
double nearestByHand(const SurfaceModel& model, const Point& from, const Point& direction) {
    double best = 1e9;
    for (const Face& face : model.faces) {
        const Point a = model.vertices[face.corners[0]];
        const Point ab = model.vertices[face.corners[1]] - a;
        const Point ac = model.vertices[face.corners[2]] - a;
        Eigen::Matrix3d system;
        system << ab, ac, -direction;
        if (std::abs(system.determinant()) < 1e-14) continue;
        const Point solution = system.inverse() * (from - a);
        if (solution.x() < 0 || solution.y() < 0 || solution.x() + solution.y() > 1 || solution.z() < 0)
            continue;
        best = std::min(best, solution.z());
    }
    return best;
}

TEST(RayTracer, FindsTheNearestFaceOfACar) {
    Random random(3);
    const SurfaceModel car = shapeKind("car")->build(ParameterSet(shapeKind("car")->parameters()), random);
    const RayTracer tracer(car);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const Point from(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(1.6, 8));
        const Point to(random.uniform(-2.6, 2.6), random.uniform(-1, 1), random.uniform(0, 1.4));
        const Point direction = (to - from).normalized();
        const double expected = nearestByHand(car, from, direction);
        const auto hit = tracer.cast(from.cast<float>(), direction.cast<float>(), 0, 100);
        if (expected > 100) {
            EXPECT_FALSE(hit);
            continue;
        }
        // Rays that graze an edge may go either way in single precision.
        if (!hit || std::abs(static_cast<double>(hit->distance) - expected) > 1e-3) continue;
        ++hits;
    }
    EXPECT_GT(hits, 220);
}

TEST(RayTracer, KeepsToItsRangeAndSeesPastNothing) {
    ModelBuilder builder;
    builder.part("wall").material(Material::concrete);
    builder.box({0, 0, 0}, {2, 2, 2});
    const RayTracer tracer(builder.take());
    const auto hit = tracer.cast({-5, 0.2F, 0.3F}, {1, 0, 0}, 0, 100);
    ASSERT_TRUE(hit);
    EXPECT_FLOAT_EQ(hit->distance, 4);
    EXPECT_FLOAT_EQ(std::abs(tracer.normal(hit->face).x()), 1);
    EXPECT_FALSE(tracer.cast({-5, 0.2F, 0.3F}, {1, 0, 0}, 0, 3.9F));
    EXPECT_FLOAT_EQ(tracer.cast({-5, 0.2F, 0.3F}, {1, 0, 0}, 4.5F, 100)->distance, 6);
    EXPECT_FALSE(tracer.sees({-5, 0, 0.1F}, {5, 0, 0.1F}, 0.01F));
    EXPECT_TRUE(tracer.sees({-5, 0, 1.2F}, {5, 0, 1.2F}, 0.01F));
    EXPECT_TRUE(tracer.sees({-5, 0, 0.1F}, {-1, 0, 0.1F}, 0.01F)) << "the end's own surface does not hide it";
}

}  // namespace
}  // namespace vestige
