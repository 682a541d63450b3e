#include "core/measurement/fit/SilhouetteFit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace vestige {
namespace {

double cumulative(double x) {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// The integral of the cumulative normal distribution up to x.
double integrated(double x) {
    return x * cumulative(x) + std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi);
}

struct Seen {
    double place;  ///< outwards from the line
    double blur;
    double weight;
};

/// Negative log likelihood of an end at `end`, of what lies from `start` outwards.
double misfit(const std::vector<Seen>& seen, double end, double start, double stop) {
    constexpr double kStrays = 0.03;
    double sum = 0;
    for (const Seen& each : seen) {
        const double share = each.blur * integrated((end - start) / each.blur);
        const double density = cumulative((end - each.place) / each.blur) / std::max(share, 1e-9);
        sum -= each.weight * std::log((1 - kStrays) * density + kStrays / (stop - start));
    }
    return sum;
}

}  // namespace

std::optional<LineFit> silhouetteOf(const Neighbourhood& near, const PlaneFit& plane, const LineFit& about) {
    if (!near.hasBeams) return std::nullopt;
    Eigen::Vector3d out = about.direction.cross(plane.normal).normalized();
    const double reach = 3 * std::max(plane.rms, 0.3 * near.noise_m);
    const double half = 0.5 * near.radius_m;
    const double depth = 0.55 * near.radius_m;
    double balance = 0;
    std::vector<double> energies;
    for (const FitPoint& point : near.points) {
        if (std::abs(plane.distance(point.position)) > reach) continue;
        const double place = out.dot(point.position - about.point);
        if (std::abs(place) < depth) balance += place;
        energies.push_back(point.energy);
    }
    if (energies.empty()) return std::nullopt;
    if (balance > 0) out = -out;
    const auto whole =
        energies.begin() + static_cast<std::ptrdiff_t>(0.6 * static_cast<double>(energies.size()));
    std::nth_element(energies.begin(), whole, energies.end());

    std::vector<Seen> seen;
    for (const double most : {0.4, 0.6, 0.9}) {
        seen.clear();
        double inside = 0;
        for (const FitPoint& point : near.points) {
            if (point.range_m <= 0 || std::abs(plane.distance(point.position)) > reach) continue;
            const Eigen::Vector3d from = point.position - about.point;
            const double place = out.dot(from);
            if (std::abs(place) > depth || std::abs(about.direction.dot(from)) > half) continue;
            // A beam from outside sees the flank too, whose upper points would pass for the surface's.
            if (point.beam.dot(out) < -0.05) continue;
            const double blur = near.blur_m(point, out);
            if (blur > most * near.noise_m) continue;
            const double share = *whole > 0 ? std::min(1.0, point.energy / *whole) : 1;
            seen.push_back({place, std::max(blur, 0.001), share});
            if (place < 0) inside += share;
        }
        if (inside >= 25) break;
        seen.clear();
    }
    if (seen.empty()) return std::nullopt;

    const double start = -depth;
    double best = 0;
    double least = std::numeric_limits<double>::infinity();
    const double step = 0.05 * near.noise_m + 1e-4;
    for (double end = -0.7 * depth; end <= 0.7 * depth; end += step) {
        const double value = misfit(seen, end, start, depth);
        if (value >= least) continue;
        least = value;
        best = end;
    }
    if (std::abs(best) > 0.69 * depth) return std::nullopt;
    // Finer, by the parabola through three places.
    const double before = misfit(seen, best - step, start, depth);
    const double after = misfit(seen, best + step, start, depth);
    const double bend = before - 2 * least + after;
    if (bend > 0) best += std::clamp(0.5 * (before - after) / bend, -1.0, 1.0) * step;
    // How far the end can move until the likelihood has fallen by half a unit, each way.
    least = std::min(least, misfit(seen, best, start, depth));
    double spread = 0;
    for (const double way : {-1.0, 1.0}) {
        double distance = step;
        while (distance < depth && misfit(seen, best + way * distance, start, depth) < least + 0.5)
            distance += 0.5 * step;
        spread += 0.5 * distance;
    }
    LineFit line = about;
    line.point += best * out;
    line.inliers = seen.size();
    const double along = near.spacing_m * near.spacing_m / 12;
    line.covariance = spread * spread * out * out.transpose() +
                      plane.varianceAt(line.point) * plane.normal * plane.normal.transpose() +
                      along * about.direction * about.direction.transpose();
    return line;
}

}  // namespace vestige
