#include <algorithm>
#include <array>
#include <cmath>

#include "core/measurement/kinds/KindInput.h"

namespace vestige {
namespace {

using Line = std::vector<std::pair<double, double>>;  // along, depth

/// Depth at `x` on a line through points ascending in x; level beyond its ends.
double depthAt(const Line& line, double x) {
    if (x <= line.front().first) return line.front().second;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto& [x1, y1] = line[i];
        const auto& [x0, y0] = line[i - 1];
        if (x <= x1) return x1 > x0 ? y0 + (y1 - y0) * (x - x0) / (x1 - x0) : y1;
    }
    return line.back().second;
}

/// A level frame: x along the line from one point to another, y to its left, metres.
struct Frame {
    Eigen::Vector2d from, along;
    double length = 0;

    Frame(const Eigen::Vector3d& a, const Eigen::Vector3d& b) : from(a.head<2>()) {
        const Eigen::Vector2d whole = (b - a).head<2>();
        length = whole.norm();
        along = length > 0 ? Eigen::Vector2d(whole / length) : Eigen::Vector2d::UnitX();
    }
    Eigen::Vector2d left() const { return {-along.y(), along.x()}; }
    Eigen::Vector2d of(const Eigen::Vector3d& point) const {
        const Eigen::Vector2d off = point.head<2>() - from;
        return {along.dot(off), left().dot(off)};
    }
    Eigen::Vector2d middle() const { return from + 0.5 * length * along; }
};

/// Points in the frame, ascending along it, depths times `side`.
Line lineOf(std::span<const KindEnd> ends, const Frame& frame, double side) {
    Line line;
    for (const KindEnd& end : ends) {
        const Eigen::Vector2d placed = frame.of(end.position);
        line.emplace_back(placed.x(), side * placed.y());
    }
    std::stable_sort(line.begin(), line.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return line;
}

double meanDepth(const Line& line) {
    double sum = 0;
    for (const auto& [x, y] : line) sum += y / static_cast<double>(line.size());
    return sum;
}

/// How far the undamaged outline lies outside of the base line, by place along it: the outline traced on the
/// undamaged side, laid onto the base line end to end.
Line bulgeOf(std::span<const KindEnd> outline, const Frame& base, const Eigen::Vector2d& inward,
             bool elsewhere) {
    const Frame other(outline.front().position, outline.back().position);
    // Outlines of opposite sides face each other; one of the same side has the same inside. A vehicle on
    // another scan may stand anywhere: there the outline is one that bulges, as all whole fronts, rears and
    // sides do.
    const Eigen::Vector2d across = base.middle() - other.middle();
    const double towards = other.left().dot(across);
    double side = std::abs(towards) > 0.3 * other.length ? (towards > 0 ? 1 : -1)
                                                         : (other.left().dot(inward) > 0 ? 1 : -1);
    Line line = lineOf(outline, other, -side);
    if (elsewhere && meanDepth(line) < 0)
        for (auto& [x, y] : line) y = -y;
    for (auto& [x, y] : line) x *= base.length / other.length;
    return line;
}

}  // namespace

Result<KindValues> crushValues(const KindInput& input) {
    const auto stations = static_cast<std::size_t>(input.settings.integer("stations"));
    const auto traced = static_cast<std::size_t>(input.settings.integer("outline_points"));
    if (input.size() < 2 + 2 + traced) return fail(ErrorCode::input, "the damage has fewer than two points");
    const Frame base(input.at(0), input.at(1));
    if (!(base.length > 0)) return fail(ErrorCode::input, "the undamaged ends are one and the same");
    const auto picks = input.ends.subspan(2, input.size() - 2 - traced);
    const double side = meanDepth(lineOf(picks, base, 1)) < 0 ? -1 : 1;
    const Line damage = lineOf(picks, base, side);
    const double start = damage.front().first, width = damage.back().first - start;
    if (!(width > 0)) return fail(ErrorCode::input, "the points of the damage lie over one place");
    Line bulge{{0, 0}, {base.length, 0}};
    if (traced > 0) {
        bulge = bulgeOf(input.ends.last(traced), base, side * base.left(),
                        input.ends.back().body != input.ends.front().body);
        if (!std::isfinite(bulge.back().first))
            return fail(ErrorCode::input, "the outline's ends are one and the same");
    }

    std::vector<double> depths;
    KindSeries crushed{"damaged", {}}, whole{"undamaged outline", {}};
    for (std::size_t i = 0; i < stations; ++i) {
        const double x = start + width * static_cast<double>(i) / static_cast<double>(stations - 1);
        const double out = depthAt(bulge, x), in = depthAt(damage, x);
        depths.push_back(in + out);
        crushed.points.emplace_back(x - start, -in);
        whole.points.emplace_back(x - start, out);
    }
    const double step = width / static_cast<double>(stations - 1);
    double area = 0, moment = 0;
    for (std::size_t i = 1; i < stations; ++i) {
        const double c0 = depths[i - 1], c1 = depths[i];
        area += 0.5 * step * (c0 + c1);
        moment += step * (c0 * c0 + c0 * c1 + c1 * c1) / 6;
    }
    double lowest = picks.front().position.z(), highest = lowest, level = 0;
    for (const KindEnd& end : picks) {
        lowest = std::min(lowest, end.position.z());
        highest = std::max(highest, end.position.z());
        level += end.position.z() / static_cast<double>(picks.size());
    }
    KindValues values{{{"crush_mean", "Mean crush", QuantityUnit::metre, area / width}}};
    for (std::size_t i = 0; i < stations; ++i)
        values.quantities.push_back(
            {"c" + std::to_string(i + 1), "C" + std::to_string(i + 1), QuantityUnit::metre, depths[i]});
    const auto add = [&](const char* key, const char* label, QuantityUnit unit, double value) {
        values.quantities.push_back({key, label, unit, value});
    };
    add("crush_max", "Largest crush", QuantityUnit::metre, *std::max_element(depths.begin(), depths.end()));
    add("damage_width", "Damage width L", QuantityUnit::metre, width);
    add("damage_offset", "Middle of the damage from the middle of the base line D", QuantityUnit::metre,
        start + 0.5 * width - 0.5 * base.length);
    add("damage_area", "Area of the damage in plan", QuantityUnit::squareMetre, area);
    if (area > 0) add("damage_centroid", "Depth of the area's centroid", QuantityUnit::metre, moment / area);
    add("level", "Height of the plane measured in", QuantityUnit::metre, level);
    add("level_spread", "Spread of the heights", QuantityUnit::metre, highest - lowest);
    values.series = {std::move(whole), std::move(crushed)};
    return values;
}

const ParameterTable& crushParameters() {
    static const ParameterTable table{
        {"stations",
         "",
         "Stations",
         "",
         ParameterType::integer,
         std::int64_t{6},
         2.0,
         20.0,
         {},
         "How many evenly spaced depths are given: 6 for C1 to C6."},
        {"outline_points",
         "",
         "Points of the undamaged outline",
         "",
         ParameterType::integer,
         std::int64_t{0},
         0.0,
         100.0,
         {},
         "How many picks at the end trace the undamaged outline, on the other side of the vehicle or on a "
         "scan of "
         "another, from the end that matches the first undamaged one; it is laid onto the damaged side from "
         "end "
         "to end. 0: the outline is the straight line between the two undamaged ends."}};
    return table;
}

}  // namespace vestige
