#include <algorithm>
#include <cmath>
#include <vector>

#include "core/simulation/shapes/Car.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;
constexpr int kRows = 16;
constexpr double kEndShare = 0.75;  // up to this share of the width a column belongs to the front or rear

/// An upright line of the body's skin in plan view: length share u, width share v, lower and upper edge.
struct Column {
    double u;
    double v;
    double lower;
    double upper;
    bool end;  ///< of the front or rear end
};

Column columnAt(const CarShape& shape, double u, double v, bool end) {
    const double x = u * shape.halfLength;
    return {u, v, shape.lowerEdge(x), shape.deckHeight(x), end};
}

/// From the middle of the front round one side to the middle of the rear.
std::vector<Column> outline(const CarShape& shape) {
    constexpr int kEndColumns = 15;
    std::vector<Column> columns;
    for (int i = 0; i < kEndColumns; ++i) {
        const double v = kEndShare * i / kEndColumns;
        columns.push_back(columnAt(shape, CarShape::planLength(v), v, true));
    }
    const double corner = CarShape::planLength(kEndShare);
    constexpr int kSideColumns = 130;
    std::vector<double> shares;
    for (int i = 0; i <= kSideColumns; ++i) shares.push_back(corner * (1 - 2.0 * i / kSideColumns));
    for (const double axle : {shape.axle, -shape.axle}) {
        // Both sides of an arch's foot, so that the sill ends upright there.
        for (const double x : {axle - shape.archRadius, axle + shape.archRadius})
            for (const double inwards : {-1e-5, 1e-5}) shares.push_back((x + inwards) / shape.halfLength);
    }
    shares.push_back(shape.cowl / shape.halfLength);
    shares.push_back(shape.rearBase / shape.halfLength);
    std::sort(shares.begin(), shares.end(), std::greater<>());
    for (const double u : shares) columns.push_back(columnAt(shape, u, CarShape::planWidth(u), false));
    for (int i = kEndColumns - 1; i >= 0; --i) {
        const double v = kEndShare * i / kEndColumns;
        columns.push_back(columnAt(shape, -CarShape::planLength(v), v, true));
    }
    return columns;
}

Point skin(const CarShape& shape, const Column& column, int row, double side) {
    const double z = column.lower + (column.upper - column.lower) * row / kRows;
    const double towardsEnd =
        std::max(0.0, std::abs(column.u) - CarShape::kStraightTo) / (1 - CarShape::kStraightTo);
    const double x = column.u * shape.halfLength - std::copysign(towardsEnd * shape.endRecess(z), column.u);
    return {x, side * column.v * shape.halfWidth * shape.widthShare(z), z};
}

Material endMaterial(const CarShape& shape, const Column& column, const Point& at) {
    const bool front = column.u > 0;
    if (column.v >= 0.48 && at.z() > (front ? 0.58 : 0.72) && at.z() < (front ? 0.69 : 0.86))
        return Material::lampCover;
    if (front && column.v < 0.42 && at.z() > 0.30 && at.z() < 0.56) return Material::plastic;
    if (!front && column.v < 0.25 && at.z() > 0.60 && at.z() < 0.70) return Material::metal;
    return shape.paint;
}

void addSkin(ModelBuilder& builder, const CarShape& shape, const std::vector<Column>& columns, double side) {
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
        const Column& here = columns[i];
        const Column& next = columns[i + 1];
        const bool end = here.end || next.end;
        builder.part(end ? (here.u > 0 ? "front" : "rear") : (side > 0 ? "left side" : "right side"));
        for (int row = 0; row < kRows; ++row) {
            const Point low = skin(shape, here, row, side);
            builder.material(end ? endMaterial(shape, here, low) : shape.paint);
            builder.quad(low, skin(shape, next, row, side), skin(shape, next, row + 1, side),
                         skin(shape, here, row + 1, side));
        }
    }
}

/// Bonnet or boot: from side to side between two neighbouring columns, slightly crowned.
void addDeck(ModelBuilder& builder, const CarShape& shape, const Column& here, const Column& next) {
    constexpr int kAcross = 12;
    const auto at = [&](int row, int across) -> Point {
        const Column& column = row == 0 ? here : next;
        const double share = 2.0 * across / kAcross - 1;
        Point point = skin(shape, column, kRows, 1);
        point.y() *= share;
        point.z() += 0.035 * column.v * (1 - share * share);
        return point;
    };
    builder.grid(1, kAcross, at);
}

/// The narrow shelf between the body's upper edge and the foot of the side windows.
void addShelf(ModelBuilder& builder, const CarShape& shape, const Column& here, const Column& next) {
    for (const double side : {-1.0, 1.0}) {
        const Point a = skin(shape, here, kRows, side);
        const Point b = skin(shape, next, kRows, side);
        builder.quad(a, b, {b.x(), side * shape.beltWidth(), b.z()},
                     {a.x(), side * shape.beltWidth(), a.z()});
    }
}

}  // namespace

void addCarBody(ModelBuilder& builder, const CarShape& shape) {
    const std::vector<Column> columns = outline(shape);
    for (const double side : {-1.0, 1.0}) addSkin(builder, shape, columns, side);
    builder.material(shape.paint);
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
        const double middle = 0.5 * (columns[i].u + columns[i + 1].u) * shape.halfLength;
        if (middle > shape.cowl) {
            addDeck(builder.part("bonnet"), shape, columns[i], columns[i + 1]);
        } else if (middle < shape.rearBase) {
            addDeck(builder.part("boot"), shape, columns[i], columns[i + 1]);
        } else {
            addShelf(builder.part("belt"), shape, columns[i], columns[i + 1]);
        }
    }
}

}  // namespace vestige
