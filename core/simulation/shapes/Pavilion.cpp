#include <cmath>

#include "core/simulation/PavilionScene.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

constexpr double kHalfLength_m = 4.0;
constexpr double kHalfWidth_m = 2.4;
constexpr double kEaves_m = 2.5;

void addPaving(ModelBuilder& builder, Random& random) {
    // Slabs of 0.6 m whose edges stand up to some millimetres above each other.
    builder.part("paving").material(Material::concrete);
    constexpr double kSlab = 0.6;
    for (int i = -9; i < 9; ++i)
        for (int j = -6; j < 6; ++j)
            builder.box({kSlab * (i + 0.5), kSlab * (j + 0.5), -0.05 + random.normal(0, 0.002)},
                        {kSlab - 0.01, kSlab - 0.01, 0.1});
}

void addFrame(ModelBuilder& builder) {
    builder.part("frame").material(Material::bark);
    for (const double y : {-kHalfWidth_m, kHalfWidth_m}) {
        for (int i = 0; i <= 4; ++i) {
            const double x = -kHalfLength_m + 2 * i;
            builder.box({x, y, 0.5 * kEaves_m}, {0.16, 0.16, kEaves_m});
            builder.box({x, y, 0.10}, {0.30, 0.30, 0.20});
            const double inward = y > 0 ? -0.5 : 0.5;
            builder.tube({x, y, kEaves_m - 0.6}, {x, y + inward, kEaves_m}, 0.05, 8);
        }
        builder.box({0, y, kEaves_m + 0.10}, {2 * kHalfLength_m + 0.8, 0.14, 0.20});
    }
    // Rafters of the open half.
    for (int i = 0; i <= 6; ++i)
        builder.box({0.3 + 0.63 * i, 0, kEaves_m + 0.27}, {0.08, 2 * kHalfWidth_m + 0.8, 0.14});
}

void addRoof(ModelBuilder& builder) {
    builder.part("roof").material(Material::plastic);
    const double left = -kHalfLength_m - 0.4, right = 0.2, side = kHalfWidth_m + 0.4;
    const double low = kEaves_m + 0.2, high = kEaves_m + 1.3;
    const Point a(left, -side, low), b(right, -side, low), c(right, side, low), d(left, side, low);
    const Point ridgeA(left + 1.6, 0, high), ridgeB(right - 1.6, 0, high);
    builder.quad(a, b, ridgeB, ridgeA);
    builder.quad(c, d, ridgeA, ridgeB);
    builder.triangle(b, c, ridgeB);
    builder.triangle(d, a, ridgeA);
}

void addFurniture(ModelBuilder& builder) {
    builder.part("furniture").material(Material::bark);
    const auto bench = [&](double x, double y, double back) {
        builder.box({x, y, 0.43}, {1.6, 0.40, 0.05});
        builder.box({x, y + back, 0.68}, {1.6, 0.04, 0.28});
        for (const double end : {-0.65, 0.65}) builder.box({x + end, y, 0.2}, {0.08, 0.36, 0.41});
    };
    bench(1.3, -2.05, -0.18);
    bench(-2.9, -2.05, -0.18);
    bench(2.9, 2.05, 0.18);
    builder.box({-1.1, 0.95, 0.73}, {1.3, 0.7, 0.04});
    for (const double x : {-1.6, -0.6})
        for (const double y : {0.7, 1.2}) builder.box({x, y, 0.355}, {0.07, 0.07, 0.71});
    builder.part("low wall").material(Material::concrete);
    builder.box({-2.0, kHalfWidth_m, 0.28}, {3.6, 0.24, 0.56});
    for (int step = 0; step < 3; ++step)
        builder.box({0.5, 4.2 + 0.35 * step, 0.075 * (step + 1)}, {3.2, 0.35, 0.15 * (step + 1)});
}

void addVines(ModelBuilder& builder, Random& random) {
    builder.part("vines").material(Material::leaf);
    for (const double y : {-kHalfWidth_m, kHalfWidth_m}) {
        addLeaves(builder, {1.6, y, kEaves_m + 0.15}, {2.8, 0.22, 0.25}, 1500, 0.08, false, random);
        for (const double x : {0.0, 2.0, 4.0})
            addLeaves(builder, {x, y, 1.3}, {0.18, 0.18, 1.2}, x > 3 ? 420 : 160, 0.08, false, random);
    }
    for (int i = 0; i < 10; ++i)
        addLeaves(builder, {random.uniform(0.2, 4.1), random.uniform(-2.2, 2.2), kEaves_m + 0.3},
                  {0.5, 0.5, 0.16}, 170, 0.08, true, random);
}

}  // namespace

void addPavilion(ModelBuilder& builder, Random& random) {
    addPaving(builder, random);
    addFrame(builder);
    addRoof(builder);
    addFurniture(builder);
    addVines(builder, random);
}

}  // namespace vestige
