#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "core/simulation/shapes/Car.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;
constexpr double kTyreWidth = 0.205;

std::string sideName(double side) {
    return side > 0 ? "left" : "right";
}

void addWheel(ModelBuilder& builder, const CarShape& shape, double x, double side) {
    const double r = shape.wheelRadius;
    const std::string place = std::string(x > 0 ? "front " : "rear ") + sideName(side);
    const Point outwards(0, side, 0);
    const Point inner(x, side * (shape.halfWidth - 0.03 - kTyreWidth), r);
    const Point forward(1, 0, 0);
    builder.part("tyre " + place).material(Material::rubber);
    builder.lathe(inner, outwards, forward,
                  {{0.64 * r, 0},
                   {0.93 * r, 0},
                   {r, 0.03},
                   {r, 0.175},
                   {0.93 * r, kTyreWidth},
                   {0.68 * r, kTyreWidth},
                   {0.67 * r, 0.19}},
                  64);
    const std::string feature = std::string("wheel_") + (x > 0 ? "front_" : "rear_") + sideName(side);
    for (const double end : {1.0, -1.0})
        builder.feature(feature + (end > 0 ? "_a" : "_b"), inner + 0.175 * outwards + end * r * forward,
                        {0, side, 0.12}, "plane");
    builder.part("rim " + place).material(Material::metal);
    builder.lathe(inner, outwards, forward,
                  {{0.67 * r, 0.19}, {0.64 * r, 0.12}, {0.20 * r, 0.10}, {0.17 * r, 0.18}, {0, 0.185}}, 32);
    for (int spoke = 0; spoke < 5; ++spoke) {
        const double angle = 2 * std::numbers::pi * spoke / 5 + 0.3;
        const Point arm(std::cos(angle), 0, std::sin(angle));
        builder.tube(inner + 0.165 * outwards + 0.1 * r * arm, inner + 0.165 * outwards + 0.66 * r * arm,
                     0.024, 8);
    }
}

/// The wheel house that closes the body behind the arch.
void addLiner(ModelBuilder& builder, const CarShape& shape, double x, double side) {
    builder.part("wheel house").material(Material::plastic);
    constexpr int kSteps = 24;
    builder.grid(1, kSteps, [&](int row, int column) -> Point {
        const double angle = std::numbers::pi * column / kSteps;
        const double z = shape.wheelRadius + shape.archRadius * std::sin(angle);
        const double outer = shape.halfWidth * shape.widthShare(z) - 0.002;
        return {x + shape.archRadius * std::cos(angle), side * (row == 0 ? outer : outer - 0.30), z};
    });
}

/// A rounded rectangle in the mirror's plane: half sizes times `scale` at share `angle` of the turn.
Point rimPoint(double halfWidth, double halfHeight, double scale, double angle) {
    const auto flattened = [](double value) { return std::copysign(std::sqrt(std::abs(value)), value); };
    return {0, scale * halfWidth * flattened(std::cos(angle)),
            scale * halfHeight * flattened(std::sin(angle))};
}

void addMirror(ModelBuilder& builder, const CarShape& shape, double side) {
    constexpr double kHalfHeight = 0.07;
    constexpr int kAround = 64;
    // From the glass to the nose: distance before the rim, share of the rim's size. The rim is the widest.
    constexpr std::array<std::pair<double, double>, 9> kLoft{{{0.010, 0.0},
                                                              {0.010, 0.93},
                                                              {0, 0.94},
                                                              {0, 1},
                                                              {0.03, 0.97},
                                                              {0.06, 0.88},
                                                              {0.08, 0.72},
                                                              {0.09, 0.45},
                                                              {0.092, 0}}};
    const double half = 0.5 * shape.mirrorWidth;
    const Point middle(shape.mirrorX, side * (shape.mirrorInner + half), shape.mirrorZ);
    builder.part(sideName(side) + " mirror");
    builder.grid(
        static_cast<int>(kLoft.size()) - 1, kAround,
        [&](int row, int column) -> Point {
            const auto& [before, scale] = kLoft[static_cast<std::size_t>(row)];
            const double angle = 2 * std::numbers::pi * (column % kAround) / kAround;
            return middle + Point(before, 0, 0) + rimPoint(half, kHalfHeight, scale, angle);
        },
        [&](int row, int) { return row == 0 ? Material::mirrorGlass : shape.paint; });
    const Point look(-1, side * 0.2, 0.35);
    builder.feature("mirror_" + sideName(side) + "_outer", middle + Point(0, side * half, 0), look,
                    "surface");
    builder.feature("mirror_" + sideName(side) + "_inner", middle - Point(0, side * half, 0), look,
                    "surface");
    builder.part(sideName(side) + " mirror stalk").material(Material::plastic);
    builder.tube({shape.mirrorX + 0.05, side * 0.92 * shape.halfWidth, shape.mirrorZ - 0.09},
                 middle + Point(0.045, -side * 0.55 * half, -0.055), 0.018, 10);
}

void addHandle(ModelBuilder& builder, const CarShape& shape, double x, double side, const std::string& door) {
    constexpr double kProud = 0.045;
    const double skin = shape.halfWidth * shape.widthShare(shape.handleZ);
    const double outer = side * (skin + kProud);
    const double half = 0.5 * shape.handleLength;
    builder.part(door + " handle").material(shape.paint);
    builder.box({x, outer - side * 0.007, shape.handleZ}, {shape.handleLength, 0.014, 0.030});
    for (const double end : {-1.0, 1.0})
        builder.box({x + end * (half - 0.025), side * (skin + 0.5 * kProud - 0.01), shape.handleZ},
                    {0.03, kProud, 0.022});
    const Point look(0, side, 0.25);
    builder.feature("handle_" + door + "_front", {x + half, outer, shape.handleZ}, look, "surface");
    builder.feature("handle_" + door + "_rear", {x - half, outer, shape.handleZ}, look, "surface");
}

}  // namespace

void addCarWheels(ModelBuilder& builder, const CarShape& shape) {
    for (const double x : {shape.axle, -shape.axle}) {
        for (const double side : {-1.0, 1.0}) {
            addWheel(builder, shape, x, side);
            addLiner(builder, shape, x, side);
        }
    }
}

void addCarMirrors(ModelBuilder& builder, const CarShape& shape) {
    for (const double side : {-1.0, 1.0}) addMirror(builder, shape, side);
}

void addCarHandles(ModelBuilder& builder, const CarShape& shape) {
    for (const double side : {-1.0, 1.0}) {
        addHandle(builder, shape, shape.handleX, side, sideName(side));
        addHandle(builder, shape, shape.handleX - 0.46 * shape.halfLength, side, "rear " + sideName(side));
    }
}

}  // namespace vestige
