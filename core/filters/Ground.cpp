#include "core/filters/Ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/CancelScope.h"
#include "core/base/Numbers.h"
#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
constexpr std::size_t kMostSquares = std::size_t{1} << 22;
/// Rise over run of a pit that only a stray beneath the ground makes.
constexpr double kPitSlope = 5;
/// Points this far from the first, rough surface take part in the first planes, besides what the slope adds.
constexpr float kFirstBand_m = 0.3F;
constexpr float kLeastTolerance_m = 0.02F;
constexpr float kMostTolerance_m = 0.15F;
constexpr double kFewestForPlane = 8;

struct Box2 {
    Eigen::Vector2f min = Eigen::Vector2f::Constant(std::numeric_limits<float>::max());
    Eigen::Vector2f max = -min;
};

Box2 planOf(const UprightPoints& points) {
    std::vector<Box2> parts((points.size() + kGrain - 1) / kGrain);
    parallelChunks(points.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector2f place = points[i].head<2>();
            parts[chunk].min = parts[chunk].min.cwiseMin(place);
            parts[chunk].max = parts[chunk].max.cwiseMax(place);
        }
    });
    Box2 all;
    for (const Box2& part : parts) {
        all.min = all.min.cwiseMin(part.min);
        all.max = all.max.cwiseMax(part.max);
    }
    return all;
}

void lowestPoints(const UprightPoints& points, GroundGrid& grid) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % kGrain == 0) throwIfCancelled();
        const Eigen::Vector3f place = points[i];
        float& low = grid.heights[grid.index(place.x(), place.y())];
        if (!(low <= place.z())) low = place.z();
    }
}

/// Strays beneath the ground: squares far below an opening of the heights turned upside down.
void dropPits(GroundGrid& grid) {
    std::vector<float> turned(grid.size());
    std::transform(grid.heights.begin(), grid.heights.end(), turned.begin(), [](float h) { return -h; });
    openHeights(turned, grid.columns(), grid.rows(), 1);
    const auto limit = static_cast<float>(kPitSlope) * grid.cell();
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (-turned[i] - grid.heights[i] > limit) grid.heights[i] = std::numeric_limits<float>::quiet_NaN();
}

/// Empties the squares whose lowest points stand on something.
void dropObjects(GroundGrid& grid, const GroundOptions& options, const JobControl& control) {
    const auto cell = static_cast<double>(grid.cell());
    const int largest = std::max(1, static_cast<int>(std::ceil(0.5 * options.widest_m / cell)));
    std::vector<float> surface = grid.heights;
    std::vector<std::uint8_t> object(grid.size(), 0);
    for (int radius = 1; radius <= largest; ++radius) {
        if (control.cancelled()) throw ErrorException{cancelledError()};
        control.progress(0.2 + 0.3 * radius / largest, "what stands on the ground");
        std::vector<float> opened = surface;
        openHeights(opened, grid.columns(), grid.rows(), radius);
        const auto limit = static_cast<float>(options.slope * radius * cell);
        for (std::size_t i = 0; i < grid.size(); ++i) object[i] |= surface[i] - opened[i] > limit;
        surface.swap(opened);
    }
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (object[i]) grid.heights[i] = std::numeric_limits<float>::quiet_NaN();
}

/// What a plane through places of a square and its neighbours needs, about the square's middle.
struct Moments {
    double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;

    void add(double px, double py, double pz) {
        n += 1;
        x += px, y += py, z += pz;
        xx += px * px, xy += px * py, yy += py * py;
        xz += px * pz, yz += py * pz;
    }
};

/// Least squares z = h + a x + b y; nothing for few places or such that lie along a line.
std::optional<GroundSurface::Plane> planeOf(const Moments& m, double cell) {
    if (m.n < kFewestForPlane) return std::nullopt;
    const double mx = m.x / m.n, my = m.y / m.n, mz = m.z / m.n;
    const double xx = m.xx / m.n - mx * mx, yy = m.yy / m.n - my * my, xy = m.xy / m.n - mx * my;
    const double xz = m.xz / m.n - mx * mz, yz = m.yz / m.n - my * mz;
    const double determinant = xx * yy - xy * xy;
    // A spread of a twentieth of a square across.
    if (!(determinant > 0.0025 * cell * cell * (xx + yy))) return std::nullopt;
    const double a = (xz * yy - yz * xy) / determinant;
    const double b = (yz * xx - xz * xy) / determinant;
    return GroundSurface::Plane{static_cast<float>(mz - a * mx - b * my), static_cast<float>(a),
                                static_cast<float>(b), 0};
}

/// What lies near the surface, by the parts of each square: a part counts once, however densely a scanner has
/// covered the foot of something there.
class NearSurface {
  public:
    static constexpr int kParts = 4;  ///< along each side of a square

    NearSurface(const UprightPoints& points, const GroundGrid& grid,
                const std::vector<GroundSurface::Plane>& planes)
        : grid_(grid), planes_(planes), parts_(grid.size() * kParts * kParts), below_(grid.size()) {
        const float perPart = kParts / grid.cell();
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i % kGrain == 0) throwIfCancelled();
            const Eigen::Vector3f place = points[i];
            const std::size_t at = grid.index(place.x(), place.y());
            const Eigen::Vector2f aside = place.head<2>() - grid.centre(at);
            const GroundSurface::Plane& plane = planes[at];
            const float above =
                place.z() - plane.height - plane.alongX * aside.x() - plane.alongY * aside.y();
            if (std::abs(above) > plane.tolerance) continue;
            const auto along = [&](float offset) {
                return static_cast<std::size_t>(
                    std::clamp(static_cast<int>(offset * perPart + 0.5F * kParts), 0, kParts - 1));
            };
            Sum& part = parts_[kParts * (kParts * at + along(aside.y())) + along(aside.x())];
            part.value += above;
            part.count += 1;
            // Things only add points above the ground: the scatter is that of what lies below.
            if (above >= 0) continue;
            below_[at].value += above * above;
            below_[at].count += 1;
        }
    }

    /// Of a square at (column, row), which is `square`, and those round it.
    std::optional<GroundSurface::Plane> plane(int column, int row) const {
        const auto cell = static_cast<double>(grid_.cell());
        const float base = planes_[indexOf(column, row)].height;
        Moments sum;
        eachNear(column, row, [&](std::size_t other, int dx, int dy) {
            const GroundSurface::Plane& plane = planes_[other];
            for (int v = 0; v < kParts; ++v)
                for (int u = 0; u < kParts; ++u) {
                    const Sum& part = parts_[static_cast<std::size_t>(kParts) * (kParts * other + v) + u];
                    if (part.count == 0) continue;
                    const double x = ((u + 0.5) / kParts - 0.5) * cell;
                    const double y = ((v + 0.5) / kParts - 0.5) * cell;
                    const double z = static_cast<double>(plane.height - base) +
                                     static_cast<double>(part.value / part.count) +
                                     static_cast<double>(plane.alongX) * x +
                                     static_cast<double>(plane.alongY) * y;
                    sum.add(x + dx * cell, y + dy * cell, z);
                }
        });
        auto fitted = planeOf(sum, cell);
        if (fitted) fitted->height += base;
        return fitted;
    }

    float scatter(int column, int row) const {
        Sum all;
        eachNear(column, row, [&](std::size_t other, int, int) {
            all.value += below_[other].value;
            all.count += below_[other].count;
        });
        return all.count > 0 ? std::sqrt(all.value / all.count) : 0;
    }

  private:
    struct Sum {
        float value = 0;
        float count = 0;
    };
    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns()) +
               static_cast<std::size_t>(column);
    }
    template <class Use>
    void eachNear(int column, int row, const Use& use) const {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (column + dx >= 0 && column + dx < grid_.columns() && row + dy >= 0 &&
                    row + dy < grid_.rows())
                    use(indexOf(column + dx, row + dy), dx, dy);
    }

    const GroundGrid& grid_;
    const std::vector<GroundSurface::Plane>& planes_;
    std::vector<Sum> parts_;
    std::vector<Sum> below_;
};

/// Planes through what lies within the tolerance of `before`, which they replace.
std::vector<GroundSurface::Plane> fitted(const UprightPoints& points, const GroundGrid& grid,
                                         const std::vector<GroundSurface::Plane>& before,
                                         const GroundOptions& options) {
    const NearSurface near(points, grid, before);
    const auto fixed = options.tolerance_m ? std::optional(static_cast<float>(*options.tolerance_m))
                                           : std::optional<float>();
    std::vector<GroundSurface::Plane> planes(grid.size());
    std::vector<float> heights(grid.size(), std::numeric_limits<float>::quiet_NaN());
    parallelFor(grid.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int column = static_cast<int>(i % static_cast<std::size_t>(grid.columns()));
            const int row = static_cast<int>(i / static_cast<std::size_t>(grid.columns()));
            const auto found = near.plane(column, row);
            if (!found) continue;
            planes[i] = *found;
            planes[i].tolerance = fixed.value_or(
                std::clamp(3 * near.scatter(column, row), kLeastTolerance_m, kMostTolerance_m));
            heights[i] = found->height;
        }
    });
    // Too few points for any plane: the lowest ones are all there is to go by.
    if (std::all_of(heights.begin(), heights.end(), [](float height) { return std::isnan(height); }))
        return before;
    // Where nothing is on the ground (under a car), it goes on as round about.
    const std::vector<float> known = heights;
    fillHeights(heights, grid.columns(), grid.rows());
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (std::isnan(known[i])) planes[i] = {heights[i], 0, 0, std::max(fixed.value_or(0), 0.05F)};
    return planes;
}

}  // namespace

Result<GroundSurface> findGround(const UprightPoints& points, const GroundOptions& options,
                                 const JobControl& control) {
    if (points.size() == 0)
        return fail(ErrorCode::input, "there are no points to find the ground of", "ground");
    return guarded("ground", [&]() -> Result<GroundSurface> {
        const auto step = [&](double share, const char* what) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            control.progress(share, what);
        };
        step(0, "lowest points");
        const Box2 plan = planOf(points);
        const auto cell = static_cast<float>(options.cell_m);
        const Eigen::Vector2d steps = ((plan.max - plan.min) / cell).cast<double>().array().floor() + 1;
        if (!(steps.x() * steps.y() <= static_cast<double>(kMostSquares)))
            return fail(ErrorCode::usage,
                        "a cell of " + exactText(options.cell_m) + " m is too small for a cloud of " +
                            fixedText(static_cast<double>(plan.max.x() - plan.min.x()), 0) + " by " +
                            fixedText(static_cast<double>(plan.max.y() - plan.min.y()), 0) + " m",
                        "ground", "take a larger cell, or remove far strays first");
        GroundGrid grid(plan.min, cell, static_cast<int>(steps.x()), static_cast<int>(steps.y()));
        lowestPoints(points, grid);
        dropPits(grid);
        step(0.2, "what stands on the ground");
        dropObjects(grid, options, control);
        fillHeights(grid.heights, grid.columns(), grid.rows());
        std::vector<GroundSurface::Plane> planes(grid.size());
        for (std::size_t i = 0; i < grid.size(); ++i)
            planes[i] = {grid.heights[i], 0, 0, kFirstBand_m + static_cast<float>(options.slope) * cell};
        for (int round = 0; round < 4; ++round) {
            step(0.5 + 0.12 * round, "planes of the ground");
            planes = fitted(points, grid, planes, options);
        }
        step(1, "planes of the ground");
        return GroundSurface(std::move(grid), std::move(planes));
    });
}

std::vector<std::uint32_t> groundPoints(const UprightPoints& points, const GroundSurface& ground) {
    std::vector<std::vector<std::uint32_t>> parts((points.size() + kGrain - 1) / kGrain);
    parallelChunks(points.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3f place = points[i];
            if (std::abs(ground.heightAbove(place)) <= ground.tolerance(place))
                parts[chunk].push_back(static_cast<std::uint32_t>(i));
        }
    });
    std::vector<std::uint32_t> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace vestige
