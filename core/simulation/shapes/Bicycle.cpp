#include <cmath>
#include <numbers>

#include "core/simulation/shapes/Shapes.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

void addWheel(ModelBuilder& builder, const Point& hub, double radius, const std::string& name) {
    constexpr double kTyre = 0.02;
    const Point across(0, 1, 0);
    const Point forward(1, 0, 0);
    std::vector<std::pair<double, double>> tyre;
    constexpr int kRing = 12;
    for (int i = 0; i <= kRing; ++i) {
        const double angle = 2 * std::numbers::pi * (i % kRing) / kRing;
        // The outermost ring must have the wheel's radius to the last digit.
        tyre.emplace_back(i % kRing == 0 ? radius : radius - kTyre + kTyre * std::cos(angle),
                          kTyre * std::sin(angle));
    }
    builder.part(name).material(Material::rubber);
    builder.lathe(hub, across, forward, tyre, 64);
    const Point look(0, 1, 0);
    builder.feature(name + "_front", hub + radius * forward, look);
    builder.feature(name + "_rear", hub - radius * forward, look);
    builder.part(name + " rim").material(Material::metal);
    const double rim = radius - 2 * kTyre;
    builder.lathe(
        hub, across, forward,
        {{rim, -0.012}, {rim + 0.004, 0.012}, {rim - 0.014, 0.012}, {rim - 0.014, -0.012}, {rim, -0.012}},
        64);
    builder.tube(hub - 0.045 * across, hub + 0.045 * across, 0.022, 10);
    constexpr int kSpokes = 28;
    for (int i = 0; i < kSpokes; ++i) {
        const double angle = 2 * std::numbers::pi * i / kSpokes;
        const double side = i % 2 == 0 ? 0.03 : -0.03;
        builder.tube(hub + side * across, hub + rim * Point(std::cos(angle), 0, std::sin(angle)), 0.0011, 5);
    }
}

}  // namespace

const ParameterTable& bicycleParameters() {
    static const ParameterTable table{
        sizeParameter("length_m", "Length", 1.58, 1, 2.2, "Overall length, tyre to tyre."),
        sizeParameter("wheel_diameter_m", "Wheel diameter", 0.56, 0.3, 0.75, "Outer diameter of the tyres.")};
    return table;
}

SurfaceModel buildBicycle(const ParameterSet& parameters, Random&) {
    ModelBuilder builder;
    const double radius = 0.5 * parameters.real("wheel_diameter_m");
    const double axle = 0.5 * parameters.real("length_m") - radius;
    const Point rearHub(-axle, 0, radius);
    const Point frontHub(axle, 0, radius);
    addWheel(builder, frontHub, radius, "front_wheel");
    addWheel(builder, rearHub, radius, "rear_wheel");

    const Point crank(-0.12 * axle, 0, 0.27);
    const Point seatTop(-0.40 * axle, 0, 0.72);
    const Point headTop(0.66 * axle, 0, 0.78);
    const Point headLow(0.74 * axle, 0, 0.62);
    builder.part("frame").material(Material::whitePaint);
    builder.tube(crank, seatTop, 0.016);
    builder.tube(crank, headLow, 0.019);
    builder.tube(seatTop + Point(0.01, 0, -0.04), headTop + Point(0, 0, -0.03), 0.015);
    builder.tube(headTop, headLow, 0.02);
    for (const double side : {-0.05, 0.05}) {
        builder.tube(crank, rearHub + Point(0, side, 0), 0.009);
        builder.tube(seatTop + Point(0, 0, -0.05), rearHub + Point(0, side, 0), 0.008);
        builder.tube(headLow + Point(0, side, 0), frontHub + Point(0, side, 0), 0.012);
    }
    builder.tube(headLow + Point(0, -0.05, 0), headLow + Point(0, 0.05, 0), 0.014);
    builder.part("saddle").material(Material::plastic);
    const Point saddle = seatTop + Point(-0.05, 0, 0.12);
    builder.tube(seatTop, saddle, 0.012);
    builder.tube(saddle + Point(-0.10, 0, 0.02), saddle + Point(0.16, 0, 0.02), 0.075, 0.02, 12);
    builder.part("handlebar").material(Material::metal);
    const Point stem = headTop + Point(-0.01, 0, 0.14);
    builder.tube(headTop, stem, 0.013);
    for (const double side : {-1.0, 1.0}) {
        const Point bend = stem + Point(0.05, side * 0.12, 0.02);
        builder.tube(stem, bend, 0.012);
        builder.tube(bend, stem + Point(-0.08, side * 0.28, 0.0), 0.012, 0.016, 10);
    }
    builder.part("cranks").material(Material::metal);
    builder.lathe(crank + Point(0, -0.05, 0), {0, 1, 0}, {1, 0, 0},
                  {{0, 0}, {0.09, 0}, {0.09, 0.006}, {0, 0.006}}, 24);
    for (const double side : {-1.0, 1.0}) {
        const Point pedal = crank + Point(side * 0.15, side * 0.09, -side * 0.06);
        builder.tube(crank + Point(0, side * 0.06, 0), pedal, 0.010);
        builder.box(pedal + Point(0, side * 0.05, 0), {0.09, 0.09, 0.02});
    }
    return builder.take();
}

}  // namespace vestige
