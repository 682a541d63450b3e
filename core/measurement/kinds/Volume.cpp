#include <algorithm>
#include <cmath>
#include <limits>

#include "core/measurement/kinds/KindInput.h"
#include "core/measurement/kinds/PlaneThrough.h"
#include "core/measurement/kinds/Reference.h"

namespace vestige {
namespace {

constexpr std::size_t kMostCells = 250'000;

bool isInside(std::span<const KindEnd> outline, const Eigen::Vector2d& place) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Eigen::Vector3d &a = outline[i].position, &b = outline[j].position;
        if ((a.y() > place.y()) != (b.y() > place.y()) &&
            place.x() < (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

struct Cell {
    double sum = 0;  ///< of heights over the base
    double squares = 0;
    std::size_t count = 0;
    double baseSum = 0;  ///< of the other surface, where there is one
    std::size_t baseCount = 0;
    bool inside = false;

    bool isFilled(bool onSurface) const { return count > 0 && (!onSurface || baseCount > 0); }
    double mean() const { return sum / static_cast<double>(count); }
    double base() const { return baseCount > 0 ? baseSum / static_cast<double>(baseCount) : 0; }
};

/// Cells over the outline's box, in plan.
struct Grid {
    Eigen::Vector2d from;
    double cell = 0;
    Eigen::Index columns = 0, rows = 0;
    std::vector<Cell> cells;

    Cell* at(const Eigen::Vector2d& place) {
        const Eigen::Vector2d index = (place - from) / cell;
        if (!(index.x() >= 0) || !(index.y() >= 0)) return nullptr;
        const auto column = static_cast<Eigen::Index>(index.x()), row = static_cast<Eigen::Index>(index.y());
        if (column >= columns || row >= rows) return nullptr;
        return &cells[static_cast<std::size_t>(row * columns + column)];
    }
};

/// Height of the base under a place.
Result<PlaneThrough> baseOf(const KindInput& input) {
    std::vector<Eigen::Vector3d> corners;
    double lowest = std::numeric_limits<double>::infinity();
    for (const KindEnd& end : input.ends) {
        corners.push_back(end.position);
        lowest = std::min(lowest, end.position.z());
    }
    if (input.settings.boolean("level_base"))
        return PlaneThrough{{corners.front().x(), corners.front().y(), lowest}, Eigen::Vector3d::UnitZ(), 0};
    auto plane = planeThrough(corners);
    if (plane && std::abs(plane->normal.z()) < 0.1)
        return fail(ErrorCode::input, "the outline stands upright, so nothing is above it");
    return plane;
}

/// Twice the spacing that the points have on average, at least a hundredth of the outline's box.
double automaticCell(const Eigen::Vector2d& extent, std::size_t points) {
    const double spacing = std::sqrt(extent.prod() / static_cast<double>(std::max<std::size_t>(points, 1)));
    return std::max(2 * spacing, 0.01 * extent.maxCoeff());
}

Result<Grid> gridOf(const KindInput& input, const PlaneThrough& base) {
    Eigen::Vector2d low = input.at(0).head<2>(), high = low;
    for (const KindEnd& end : input.ends) {
        low = low.cwiseMin(end.position.head<2>());
        high = high.cwiseMax(end.position.head<2>());
    }
    const Eigen::Vector2d extent = high - low;
    if (!(extent.minCoeff() > 0)) return fail(ErrorCode::input, "the outline has no area in plan");
    Grid grid;
    grid.from = low;
    grid.cell = input.settings.optionalReal("cell_m").value_or(automaticCell(extent, input.cloud.size()));
    const double wanted = std::ceil(extent.x() / grid.cell) * std::ceil(extent.y() / grid.cell);
    if (wanted > static_cast<double>(kMostCells))
        return fail(ErrorCode::input, "the outline holds more than 250000 cells; take larger ones");
    grid.columns = static_cast<Eigen::Index>(std::ceil(extent.x() / grid.cell));
    grid.rows = static_cast<Eigen::Index>(std::ceil(extent.y() / grid.cell));
    grid.cells.resize(static_cast<std::size_t>(grid.columns * grid.rows));
    for (Eigen::Index row = 0; row < grid.rows; ++row)
        for (Eigen::Index column = 0; column < grid.columns; ++column) {
            const Eigen::Vector2d middle =
                grid.from + grid.cell * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                                                        static_cast<double>(row) + 0.5);
            grid.cells[static_cast<std::size_t>(row * grid.columns + column)].inside =
                isInside(input.ends, middle);
        }
    for (const Eigen::Vector3d& point : input.cloud) {
        Cell* cell = grid.at(point.head<2>());
        if (!cell || !cell->inside) continue;
        const double height = base.signedDistance(point) / base.normal.z();
        cell->sum += height;
        cell->squares += height * height;
        ++cell->count;
    }
    for (const Eigen::Vector3d& point : input.base) {
        Cell* cell = grid.at(point.head<2>());
        if (!cell || !cell->inside) continue;
        cell->baseSum += base.signedDistance(point) / base.normal.z();
        ++cell->baseCount;
    }
    return grid;
}

/// Signed area of the outline in plan, from its first corner.
double planArea(std::span<const KindEnd> outline) {
    double twice = 0;
    const Eigen::Vector3d origin = outline.front().position;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector3d a = outline[i].position - origin;
        const Eigen::Vector3d b = outline[(i + 1) % outline.size()].position - origin;
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * std::abs(twice);
}

}  // namespace

Result<KindValues> volumeValues(const KindInput& input) {
    const auto base = baseOf(input);
    if (!base) return fail(base.error());
    const auto grid = gridOf(input, *base);
    if (!grid) return fail(grid.error());
    const bool onSurface = input.settings.integer("base_scan") > 0;
    if (onSurface && input.base.empty())
        return fail(ErrorCode::input, "the scan that is to be the base has no point here");
    double above = 0, below = 0, variance = 0;
    std::size_t inside = 0, filled = 0;
    for (const Cell& cell : grid->cells) {
        if (!cell.inside) continue;
        ++inside;
        if (!cell.isFilled(onSurface)) continue;
        ++filled;
        const double mean = cell.mean();
        const double height = mean - cell.base();
        (height > 0 ? above : below) += std::abs(height);
        const auto n = static_cast<double>(cell.count);
        const double scatter = cell.count > 1 ? std::max(0.0, cell.squares - n * mean * mean) / (n - 1)
                                              : input.cloudNoise_m * input.cloudNoise_m;
        variance += scatter / n;
        if (onSurface)
            variance += input.cloudNoise_m * input.cloudNoise_m / static_cast<double>(cell.baseCount);
    }
    if (filled == 0) return fail(ErrorCode::input, "no point of the cloud lies within the outline");
    // The outline's true area, and cells without points as the others on average.
    const double area = planArea(input.ends);
    const double perCell = area / static_cast<double>(filled);
    const double scattered = perCell * std::sqrt(variance);
    const auto quantity = [&](const char* key, const char* label, double cells) {
        QuantityValue value{key, label, QuantityUnit::cubicMetre, perCell * cells};
        value.own.push_back({"scatter of the cloud", scattered, "m3", 1, Distribution::normal,
                             std::numeric_limits<double>::infinity(), 0});
        if (onSurface)
            value.own.push_back({"height of the base", input.baseHeight_m, "m", area, Distribution::normal,
                                 std::numeric_limits<double>::infinity(), 0});
        return value;
    };
    return KindValues{{quantity("volume", "Volume above the base", above),
                       quantity("volume_below", "Volume below the base", below),
                       quantity("volume_net", "Above less below", above - below),
                       {"area_plan", "Area of the outline in plan", QuantityUnit::squareMetre, area},
                       {"coverage", "Share of the outline that has points", QuantityUnit::percent,
                        100 * static_cast<double>(filled) / static_cast<double>(inside)}}};
}

const ParameterTable& volumeParameters() {
    static const ParameterTable table{
        {"level_base",
         "",
         "Level base",
         "",
         ParameterType::boolean,
         false,
         {},
         {},
         {},
         "The base is level at the height of the lowest corner, instead of the plane fitted to all corners."},
        {"base_scan",
         "",
         "Base scan",
         "",
         ParameterType::integer,
         std::int64_t{0},
         0.0,
         1000.0,
         {},
         "Number in the list of scans, from 1, of the one whose surface is the base; 0: the plane."},
        {"cell_m",
         "",
         "Cell",
         "m",
         ParameterType::real,
         std::monostate{},
         0.001,
         10.0,
         {},
         "Side of the square cells whose mean heights are summed; automatic: twice the points' spacing."},
        referenceParameter("reference_m3", "m3")};
    return table;
}

}  // namespace vestige
