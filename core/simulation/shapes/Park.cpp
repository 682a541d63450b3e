#include <array>
#include <cmath>
#include <vector>

#include "core/simulation/PavilionScene.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

Point onLawn(double x, double y, double above = 0) {
    return {x, y, pavilionGround(x, y) + above};
}

void addLawn(ModelBuilder& builder, Random& random) {
    constexpr int kCells = 176;
    constexpr double kCell_m = 0.27;
    builder.part("lawn").material(Material::grass);
    std::vector<double> bumps((kCells + 1) * (kCells + 1));
    for (double& bump : bumps) bump = random.normal(0, 0.025);
    builder.grid(kCells, kCells, [&](int row, int column) {
        const double x = kCell_m * (row - 0.5 * kCells), y = kCell_m * (column - 0.5 * kCells);
        return onLawn(x, y, bumps[static_cast<std::size_t>(row * (kCells + 1) + column)] - 0.09);
    });
}

void addTree(ModelBuilder& builder, const Point& foot, double trunk, double clearance, double radius,
             Random& random) {
    builder.part("trees").material(Material::bark);
    const Point fork = foot + Point{random.normal(0, 0.15), random.normal(0, 0.15), clearance + 0.6 * radius};
    builder.tube(foot - Point(0, 0, 0.2), fork, trunk, 0.6 * trunk, 12);
    for (int branch = 0; branch < 7; ++branch) {
        const double angle = 0.9 * branch + random.uniform(-0.3, 0.3);
        const double start = random.uniform(0.6, 1.0);
        const Point from = foot + start * (fork - foot);
        builder.tube(from,
                     from + 0.8 * radius * Point{std::cos(angle), std::sin(angle), random.uniform(0.2, 0.8)},
                     0.3 * trunk, 0.1 * trunk, 6);
    }
    builder.material(Material::leaf);
    addLeaves(builder, foot + Point(0, 0, clearance + radius), {radius, radius, radius},
              static_cast<int>(300 * radius * radius), 0.14, true, random);
}

void addPlants(ModelBuilder& builder, Random& random) {
    struct Place {
        double x, y, trunk, clearance, radius;
    };
    constexpr std::array<Place, 9> kTrees{{{-7.5, 5.2, 0.16, 2.0, 1.9},
                                           {-10.8, -4.6, 0.24, 2.4, 2.6},
                                           {-1.5, -7.4, 0.14, 1.8, 1.6},
                                           {6.4, -6.2, 0.20, 2.2, 2.2},
                                           {8.6, 4.4, 0.13, 1.7, 1.5},
                                           {13.2, -2.5, 0.26, 2.6, 2.8},
                                           {2.6, 8.6, 0.18, 2.1, 2.0},
                                           {-15.0, 3.0, 0.30, 2.8, 3.0},
                                           {16.5, 8.5, 0.28, 2.5, 2.9}}};
    for (const Place& tree : kTrees)
        addTree(builder, onLawn(tree.x, tree.y), tree.trunk, tree.clearance, tree.radius, random);
    builder.part("bushes").material(Material::leaf);
    for (int i = 0; i < 12; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double x = -9 + 1.7 * i + random.uniform(-0.4, 0.4);
        const double size = random.uniform(0.35, 0.75);
        addLeaves(builder, onLawn(x, side * random.uniform(4.9, 6.6), size), {1.2 * size, 1.1 * size, size},
                  static_cast<int>(900 * size * size), 0.09, true, random);
    }
    builder.part("hedge");
    for (int i = 0; i < 12; ++i)
        addLeaves(builder, onLawn(-11 + 2 * i, -10.5, 0.6), {1.0, 0.4, 0.65}, 420, 0.10, false, random);
}

void addStreetFurniture(ModelBuilder& builder) {
    builder.part("statue").material(Material::concrete);
    builder.box(onLawn(-6.6, 3.4, 0.35), {0.8, 0.8, 0.9});
    builder.lathe(onLawn(-6.6, 3.4, 0.8), Point::UnitZ(), Point::UnitX(),
                  {{0, 0}, {0.25, 0}, {0.18, 0.4}, {0.26, 0.8}, {0.12, 1.0}, {0.15, 1.15}, {0, 1.3}}, 16);
    builder.part("fountain");
    builder.lathe(
        onLawn(7.6, -3.0, -0.2), Point::UnitZ(), Point::UnitX(),
        {{1.3, 0}, {1.3, 0.65}, {1.1, 0.65}, {1.1, 0.45}, {0.2, 0.45}, {0.12, 1.3}, {0.45, 1.45}, {0, 1.5}},
        32);
    builder.part("lamps").material(Material::metal);
    for (const auto& [x, y] : {std::pair{-5.2, -4.3}, {5.4, 4.1}, {12.0, 2.6}}) {
        builder.tube(onLawn(x, y, -0.2), onLawn(x, y, 3.4), 0.05, 10);
        builder.box(onLawn(x, y, 3.55), {0.28, 0.28, 0.34});
    }
}

void addBuildings(ModelBuilder& builder) {
    builder.part("garden wall").material(Material::concrete);
    builder.box({-2, 12, 0.7}, {26, 0.3, 2.6});
    builder.part("shed").material(Material::bark);
    builder.box({10.5, 9.2, 1.0}, {3.0, 2.4, 3.2});
    builder.quad({8.8, 7.8, 2.5}, {12.2, 7.8, 2.5}, {12.2, 9.2, 3.3}, {8.8, 9.2, 3.3});
    builder.quad({8.8, 10.6, 2.5}, {12.2, 10.6, 2.5}, {12.2, 9.2, 3.3}, {8.8, 9.2, 3.3});
    builder.part("house").material(Material::concrete);
    builder.box({-22.5, -3, 3.2}, {2, 22, 7.4});
    for (int floor = 0; floor < 2; ++floor)
        for (int i = 0; i < 6; ++i)
            builder.box({-21.45, -12 + 3.6 * i, 1.8 + 2.9 * floor}, {0.22, 1.3, 0.12});
}

}  // namespace

void addPark(ModelBuilder& builder, Random& random) {
    addLawn(builder, random);
    addPlants(builder, random);
    addStreetFurniture(builder);
    addBuildings(builder);
}

}  // namespace vestige
