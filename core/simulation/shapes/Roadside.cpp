#include "core/simulation/shapes/Roadside.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

/// A wall's bay in the plane y = front: a frame round an opening that is set back; `inward` is +-1 along y.
void addBay(ModelBuilder& builder, const Point& low, double width, double height, const Point& openLow,
            double openWidth, double openHeight, double depth) {
    const auto at = [&](double x, double z, double back) -> Point { return {x, low.y() + back, z}; };
    const double x0 = low.x();
    const double x1 = openLow.x();
    const double x2 = x1 + openWidth;
    const double x3 = x0 + width;
    const double z0 = low.z();
    const double z1 = openLow.z();
    const double z2 = z1 + openHeight;
    const double z3 = z0 + height;
    const auto frame = [&](double xa, double xb, double za, double zb) {
        if (xb - xa > 1e-6 && zb - za > 1e-6)
            builder.quad(at(xa, za, 0), at(xb, za, 0), at(xb, zb, 0), at(xa, zb, 0));
    };
    builder.material(Material::concrete);
    frame(x0, x1, z0, z3);
    frame(x2, x3, z0, z3);
    frame(x1, x2, z0, z1);
    frame(x1, x2, z2, z3);
    builder.quad(at(x1, z1, 0), at(x1, z2, 0), at(x1, z2, depth), at(x1, z1, depth));
    builder.quad(at(x2, z1, 0), at(x2, z2, 0), at(x2, z2, depth), at(x2, z1, depth));
    builder.quad(at(x1, z1, 0), at(x2, z1, 0), at(x2, z1, depth), at(x1, z1, depth));
    builder.quad(at(x1, z2, 0), at(x2, z2, 0), at(x2, z2, depth), at(x1, z2, depth));
    builder.material(Material::plastic);
    builder.quad(at(x1, z1, depth), at(x2, z1, depth), at(x2, z2, depth), at(x1, z2, depth));
}

void addHouse(ModelBuilder& builder, double x, double y, double width, int storeys, Random& random) {
    const double storey = random.uniform(2.7, 3.3);
    const int bays = static_cast<int>(std::floor(width / random.uniform(2.2, 3.4)));
    const double bay = width / bays;
    const int door = static_cast<int>(random.below(static_cast<std::uint64_t>(bays)));
    const double open = random.uniform(0.9, 1.4);
    const double depth = std::copysign(random.uniform(0.12, 0.30), y);
    for (int row = 0; row < storeys; ++row) {
        for (int column = 0; column < bays; ++column) {
            const Point low(x + column * bay, y, kKerbHeight + row * storey);
            const bool entrance = row == 0 && column == door;
            const Point openLow = low + Point(0.5 * (bay - open), 0, entrance ? 0.02 : 0.9);
            addBay(builder, low, bay, storey, openLow, open, entrance ? 2.1 : 1.4, depth);
        }
    }
    builder.material(Material::concrete);
    const double top = kKerbHeight + storeys * storey;
    const double back = y + std::copysign(8.0, y);
    for (const double side : {x, x + width})
        builder.quad({side, y, 0}, {side, back, 0}, {side, back, top}, {side, y, top});
    builder.box({x + 0.5 * width, y - std::copysign(0.15, y), top + 0.1}, {width, 0.3, 0.2});
}

}  // namespace

double crownHeight(double y) {
    const double share = y / kRoadHalfWidth;
    return 0.10 * (1 - share * share);
}

void addCrownedRoad(ModelBuilder& builder, double halfLength) {
    const int rows = static_cast<int>(std::ceil(halfLength));
    const auto x = [&](int row) { return halfLength * (2.0 * row / rows - 1); };
    builder.part("road").material(Material::asphalt);
    builder.grid(rows, 16, [&](int row, int column) -> Point {
        const double y = kRoadHalfWidth * (column / 8.0 - 1);
        return {x(row), y, crownHeight(y)};
    });
    for (const double side : {-1.0, 1.0}) {
        builder.part("kerb").material(Material::concrete);
        // Up the kerb, along its top, then the pavement, falling towards the road by 2 %.
        const std::array<Point, 4> section{Point(0, kRoadHalfWidth, 0), Point(0, kRoadHalfWidth, kKerbHeight),
                                           Point(0, kRoadHalfWidth + 0.25, kKerbHeight),
                                           Point(0, kRoadHalfWidth + 12, kKerbHeight + 0.235)};
        builder.grid(rows, 3, [&](int row, int column) -> Point {
            const Point& corner = section[static_cast<std::size_t>(column)];
            return {x(row), side * corner.y(), corner.z()};
        });
    }
}

void addBarrier(ModelBuilder& builder, double fromX, double toX, double y, double ground) {
    builder.part("barrier").material(Material::metal);
    constexpr std::array<std::array<double, 2>, 6> kSection{
        {{0, 0.45}, {0.08, 0.50}, {0.08, 0.56}, {0, 0.62}, {0.08, 0.68}, {0, 0.76}}};
    builder.grid(1, 5, [&](int row, int column) -> Point {
        const auto& corner = kSection[static_cast<std::size_t>(column)];
        return {row == 0 ? fromX : toX, y - std::copysign(corner[0], y), ground + corner[1]};
    });
    for (double x = fromX; x <= toX; x += 2)
        builder.box({x, y + std::copysign(0.08, y), ground + 0.36}, {0.10, 0.12, 0.72});
}

void addHouses(ModelBuilder& builder, double halfLength, double y, Random& random) {
    builder.part("houses");
    for (double x = -halfLength; x < halfLength - 6;) {
        const double width = random.uniform(7, 14);
        const double front = y + std::copysign(random.uniform(0, 1.6), y);
        addHouse(builder, x, front, width, 2 + static_cast<int>(random.below(2)), random);
        x += width + (random.uniform() < 0.25 ? random.uniform(2, 4) : 0);
    }
}

void addDebris(ModelBuilder& builder, const Eigen::Vector3d& centre, int count, Random& random) {
    builder.part("debris");
    constexpr std::array kMaterials{Material::plastic, Material::metal, Material::rubber,
                                    Material::whitePaint};
    for (int i = 0; i < count; ++i) {
        ModelBuilder piece;
        piece.part("piece").material(kMaterials[random.below(kMaterials.size())]);
        const Point size(random.uniform(0.05, 0.45), random.uniform(0.03, 0.25), random.uniform(0.01, 0.12));
        piece.box(Point::Zero(), size);
        const double x = centre.x() + random.normal(0, 2.5);
        const double y = std::clamp(centre.y() + random.normal(0, 1.5), -3.8, 3.8);
        Pose pose = Pose::Identity();
        pose.translation() = Point(x, y, crownHeight(y) + 0.4 * size.z());
        pose.rotate(Eigen::AngleAxisd(random.uniform(-3.1, 3.1), Point::UnitZ()));
        pose.rotate(Eigen::AngleAxisd(random.normal(0, 0.2), Point::UnitX()));
        builder.append(piece.take(), pose, "debris");
    }
}

}  // namespace vestige
