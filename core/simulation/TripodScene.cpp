#include "core/simulation/TripodScene.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/simulation/ModelBuilder.h"
#include "core/simulation/shapes/Roadside.h"
#include "core/simulation/shapes/Shapes.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;
constexpr double kHalfLength = 45;

/// Puts objects of shapeKinds() into a scene.
class Furnisher {
  public:
    Furnisher(ModelBuilder& builder, std::uint64_t seed) : builder_(builder), random_(seed, 300) {}

    Random& random() { return random_; }

    void add(const char* kind, const Point& at, double heading_deg,
             const std::vector<std::pair<const char*, double>>& sizes) {
        ParameterSet parameters(shapeKind(kind)->parameters());
        for (const auto& [key, value] : sizes) (void)parameters.set(key, value);
        Pose pose = Pose::Identity();
        pose.translation() = at;
        pose.rotate(Eigen::AngleAxisd(radians(heading_deg), Point::UnitZ()));
        builder_.append(shapeKind(kind)->build(parameters, random_), pose, kind + std::to_string(++objects_));
    }
    void car(double x, double y, double heading_deg, double ground) {
        add("car", {x, y, ground}, heading_deg,
            {{"length_m", random_.uniform(3.8, 5.1)},
             {"width_m", random_.uniform(1.65, 1.95)},
             {"height_m", random_.uniform(1.38, 1.75)}});
    }
    void tree(double x, double y, double ground) {
        add("tree", {x, y, ground}, random_.uniform(0, 360),
            {{"clearance_m", random_.uniform(1.8, 3.0)},
             {"canopy_radius_m", random_.uniform(1.2, 2.6)},
             {"canopy_height_m", random_.uniform(2.5, 4.5)},
             {"leaf_m", 0.22},
             {"leaf_area_density", 0.6},
             {"trunk_diameter_m", random_.uniform(0.2, 0.45)}});
    }
    void pole(double x, double y, double ground) {
        add("pole", {x, y, ground}, y > 0 ? -90 : 90,
            {{"height_m", random_.uniform(3, 9)},
             {"diameter_m", random_.uniform(0.08, 0.3)},
             {"arm_m", random_.uniform() < 0.5 ? 1.5 : 0.0}});
    }

  private:
    ModelBuilder& builder_;
    Random random_;
    int objects_ = 0;
};

void addStreet(ModelBuilder& builder, Furnisher& things) {
    Random& random = things.random();
    addCrownedRoad(builder, kHalfLength);
    addHouses(builder, kHalfLength, 9.5, random);
    addHouses(builder, kHalfLength, -13.0, random);
    const double barrier = random.uniform(-30, -14);
    addBarrier(builder, barrier, barrier + random.uniform(24, 40), -6.6, kKerbHeight + 0.05);

    const Point crash(random.uniform(-2, 2), random.uniform(-0.8, 0.8), 0);
    const double bearing = radians(random.uniform(-14, 14));
    const Point first = crash - 2.6 * Point(std::cos(bearing), std::sin(bearing), 0);
    const Point second = crash + 2.6 * Point(std::cos(bearing), std::sin(bearing), 0);
    things.car(first.x(), first.y(), random.uniform(-35, 35), crownHeight(first.y()) - 0.02);
    things.car(second.x(), second.y(), random.uniform(145, 215), crownHeight(second.y()) - 0.02);
    for (const double x : {-17.0, 13.0, 21.0}) {
        const double y = (random.uniform() < 0.5 ? -1 : 1) * random.uniform(2.85, 3.0);
        things.car(x + random.uniform(-2, 1.5), y, (y > 0 ? 180 : 0) + random.uniform(-3, 3),
                   crownHeight(y) - 0.02);
    }
    addDebris(builder, crash, 40, random);
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < 3; ++i) {
            const double x = -28 + 24 * i + random.uniform(-7, 7);
            things.pole(x, side * random.uniform(4.5, 5.2), kKerbHeight);
            things.tree(x + random.uniform(6, 14), side * random.uniform(6.9, 7.6), kKerbHeight + 0.04);
        }
    }
}

void addHall(ModelBuilder& builder, Furnisher& things) {
    Random& random = things.random();
    const double length = random.uniform(26, 40);
    const double width = random.uniform(16, 22);
    const double height = random.uniform(2.6, 3.4);
    builder.part("hall").material(Material::concrete);
    builder.box({0, 0, 0.5 * height}, {length, width, height});
    for (double x = -0.5 * length + 3; x < 0.5 * length; x += 5)
        for (const double y : {-0.18 * width, 0.18 * width})
            builder.box({x, y, 0.5 * height}, {0.4, 0.4, height});
    for (int i = 0; i < 3; ++i)
        things.car(-0.4 * length + 5.0 * static_cast<double>(random.below(5)) + 0.5 + 2.5 * i,
                   (random.uniform() < 0.5 ? -0.36 : 0.36) * width, 90 + random.uniform(-4, 4), 0);
    for (int i = 0; i < 12; ++i) {
        const Point size(random.uniform(0.3, 1.2), random.uniform(0.3, 0.8), random.uniform(0.3, 2.0));
        const double side = random.uniform() < 0.5 ? -1 : 1;
        builder.part("store").material(Material::cardboard);
        builder.box({random.uniform(-0.46, 0.46) * length, side * (0.5 * width - 0.5), 0.5 * size.z()}, size);
    }
}

void addField(ModelBuilder& builder, Furnisher& things) {
    Random& random = things.random();
    const auto wave = [](double x, double y, const std::array<double, 6>& w) {
        return w[0] * std::sin(0.21 * x + w[1]) + w[2] * std::sin(0.33 * y + w[3]) +
               w[4] * std::sin(0.15 * (x + y) + w[5]);
    };
    std::array<double, 6> waves{};
    for (std::size_t i = 0; i < 6; ++i)
        waves[i] = i % 2 == 0 ? random.uniform(0.15, 0.5) : random.uniform(0, 6);
    builder.part("ground").material(Material::grass);
    std::vector<double> bumps(61 * 61);
    for (double& bump : bumps) bump = random.normal(0, 0.05);
    builder.grid(60, 60, [&](int row, int column) -> Point {
        const double x = 1.2 * (row - 30);
        const double y = 1.2 * (column - 30);
        return {x, y, wave(x, y, waves) + bumps[static_cast<std::size_t>(61 * row + column)]};
    });
    for (int i = 0; i < 14; ++i) {
        const double x = random.uniform(-32, 32);
        const double y = random.uniform(-32, 32);
        things.tree(x, y, wave(x, y, waves) - 0.1);
    }
    builder.part("boulders").material(Material::concrete);
    for (int i = 0; i < 12; ++i) {
        const double x = random.uniform(-25, 25);
        const double y = random.uniform(-25, 25);
        const double size = random.uniform(0.3, 1.0);
        builder.lathe({x, y, wave(x, y, waves)}, Point::UnitZ(), Point::UnitX(),
                      {{size, 0}, {0.8 * size, 0.5 * size}, {0.3 * size, 0.8 * size}, {0, 0.82 * size}}, 8);
    }
}

}  // namespace

SurfaceModel buildTripodScene(const TripodSceneOptions& options) {
    ModelBuilder builder;
    Furnisher things(builder, options.seed);
    switch (options.kind) {
        case TripodSceneKind::street:
            addStreet(builder, things);
            break;
        case TripodSceneKind::hall:
            addHall(builder, things);
            break;
        case TripodSceneKind::field:
            addField(builder, things);
            break;
        case TripodSceneKind::bareRoad:
            addCrownedRoad(builder, 2 * kHalfLength);
            break;
    }
    return builder.take();
}

}  // namespace vestige
