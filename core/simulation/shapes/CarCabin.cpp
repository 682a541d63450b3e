#include <array>
#include <cmath>
#include <vector>

#include "core/simulation/shapes/Car.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

double between(double from, double to, double share) {
    return from + share * (to - from);
}

/// Share lines across a panel: `marks` where the material changes, and even steps between them.
std::vector<double> lines(const std::vector<double>& marks, int steps) {
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < marks.size(); ++i)
        for (int k = 0; k < steps; ++k)
            all.push_back(between(marks[i], marks[i + 1], static_cast<double>(k) / steps));
    all.push_back(marks.back());
    return all;
}

Point roof(const CarShape& shape, double s, double u) {
    const double bulge = 1 - u * u;
    return {between(shape.roofFront + 0.08 * bulge, shape.roofRear - 0.05 * bulge, s), u * shape.railWidth(),
            shape.railHeight(s) + 0.06 * bulge};
}

/// A windscreen: from the belt line at x `base` up to the roof's end `s`; `outwards` is how far its foot
/// bulges.
Point screen(const CarShape& shape, double base, double outwards, double s, double u, double v) {
    const Point foot(base + outwards * (1 - u * u), u * shape.beltWidth(), shape.deckHeight(base));
    return foot + v * (roof(shape, s, u) - foot);
}

Point sidePanel(const CarShape& shape, double side, double s, double t) {
    const double x = between(shape.cowl, shape.rearBase, s);
    const Point foot(x, side * shape.beltWidth(), shape.deckHeight(x));
    const Point rail = roof(shape, s, side);
    Point point = foot + t * (rail - foot);
    point.y() += side * 0.03 * (4 * t * (1 - t));  // the glass is bent
    return point;
}

/// A panel with lines `across` and `up`; cells for which `isGlass` holds are glass, the rest paint.
template <class At, class IsGlass>
void panel(ModelBuilder& builder, const CarShape& shape, const std::string& part,
           const std::vector<double>& across, const std::vector<double>& up, const At& at,
           const IsGlass& isGlass) {
    for (std::size_t i = 0; i + 1 < across.size(); ++i) {
        for (std::size_t j = 0; j + 1 < up.size(); ++j) {
            const bool glass = isGlass(0.5 * (across[i] + across[i + 1]), 0.5 * (up[j] + up[j + 1]));
            builder.part(glass ? "glass" : part).material(glass ? Material::glass : shape.paint);
            builder.quad(at(across[i], up[j]), at(across[i + 1], up[j]), at(across[i + 1], up[j + 1]),
                         at(across[i], up[j + 1]));
        }
    }
}

}  // namespace

void addCarCabin(ModelBuilder& builder, const CarShape& shape) {
    const std::vector<double> wide = lines({-1, -0.90, 0, 0.90, 1}, 4);
    const std::vector<double> high = lines({0, 0.05, 0.5, 0.93, 1}, 3);
    const auto inFrame = [](double u, double v) { return std::abs(u) < 0.90 && v > 0.05 && v < 0.93; };
    panel(
        builder, shape, "windscreen frame", wide, high,
        [&](double u, double v) { return screen(shape, shape.cowl, 0.10, 0, u, v); }, inFrame);
    panel(
        builder, shape, "rear window frame", wide, high,
        [&](double u, double v) { return screen(shape, shape.rearBase, -0.06, 1, u, v); }, inFrame);

    constexpr double kPillarA = 0.09;
    constexpr std::array<double, 2> kPillarB{0.46, 0.52};
    constexpr double kPillarC = 0.86;
    const std::vector<double> long_ = lines({0, kPillarA, kPillarB[0], kPillarB[1], kPillarC, 1}, 6);
    const std::vector<double> up = lines({0, 0.06, 0.5, 0.90, 1}, 2);
    for (const double side : {-1.0, 1.0}) {
        panel(
            builder, shape, side > 0 ? "left pillars" : "right pillars", long_, up,
            [&](double s, double t) { return sidePanel(shape, side, s, t); },
            [&](double s, double t) {
                const bool pillar = s < kPillarA || s > kPillarC || (s > kPillarB[0] && s < kPillarB[1]);
                return !pillar && t > 0.06 && t < 0.90;
            });
    }
    builder.part("roof").material(shape.paint);
    constexpr int kAlong = 16;
    constexpr int kAcross = 16;
    builder.grid(kAlong, kAcross, [&](int row, int column) {
        return roof(shape, static_cast<double>(row) / kAlong, 2.0 * column / kAcross - 1);
    });
    builder.feature("roof_front_left", roof(shape, 0, 1), {0.3, 0.5, 1}, "corner");
    builder.feature("roof_front_right", roof(shape, 0, -1), {0.3, -0.5, 1}, "corner");
    builder.feature("roof_rear_left", roof(shape, 1, 1), {-0.3, 0.5, 1}, "corner");
    builder.feature("roof_rear_right", roof(shape, 1, -1), {-0.3, -0.5, 1}, "corner");
}

void addCarInterior(ModelBuilder& builder, const CarShape& shape) {
    builder.part("interior").material(Material::fabric);
    const double wide = shape.halfWidth - 0.28;
    builder.quad({0.93 * shape.halfLength, wide, 0.22}, {-0.93 * shape.halfLength, wide, 0.22},
                 {-0.93 * shape.halfLength, -wide, 0.22}, {0.93 * shape.halfLength, -wide, 0.22});
    for (const double y : {-0.37, 0.37}) {
        builder.box({0.02 * shape.halfLength, y, 0.45}, {0.5, 0.5, 0.2});
        builder.box({-0.10 * shape.halfLength, y, 0.80}, {0.14, 0.46, 0.62});
    }
    builder.box({-0.42 * shape.halfLength, 0, 0.45}, {0.5, 1.25, 0.22});
    builder.box({-0.54 * shape.halfLength, 0, 0.78}, {0.16, 1.25, 0.52});
    builder.box({0.36 * shape.halfLength, 0, 0.76}, {0.32, 1.35, 0.26});
}

}  // namespace vestige
