#include "core/measurement/fit/SilhouetteFit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
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

struct End {
    double place = 0;
    double spread = 0;  ///< standard uncertainty
};

/// The most likely end within +-farthest; nothing where it lies at the bounds of the search.
std::optional<End> likeliest(const std::vector<Seen>& seen, double start, double stop, double farthest,
                             double step) {
    End end;
    double least = std::numeric_limits<double>::infinity();
    for (double at = -farthest; at <= farthest; at += step) {
        const double value = misfit(seen, at, start, stop);
        if (value >= least) continue;
        least = value;
        end.place = at;
    }
    if (std::abs(end.place) > farthest - 1.5 * step) return std::nullopt;
    // Finer, by the parabola through three places.
    const double before = misfit(seen, end.place - step, start, stop);
    const double after = misfit(seen, end.place + step, start, stop);
    const double bend = before - 2 * least + after;
    if (bend > 0) end.place += std::clamp(0.5 * (before - after) / bend, -1.0, 1.0) * step;
    // How far the end can move until the likelihood has fallen by half a unit, each way.
    least = std::min(least, misfit(seen, end.place, start, stop));
    for (const double way : {-1.0, 1.0}) {
        double distance = step;
        while (distance < -start && misfit(seen, end.place + way * distance, start, stop) < least + 0.5)
            distance += 0.5 * step;
        end.spread += 0.5 * distance;
    }
    return end;
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
    const double up = plane.normal.dot(near.view) > 0 ? -1 : 1;
    const auto whole =
        energies.begin() + static_cast<std::ptrdiff_t>(0.6 * static_cast<double>(energies.size()));
    std::nth_element(energies.begin(), whole, energies.end());

    // Farther out other things may stand at the same height.
    const double stop = std::min(depth, 2.5 * near.noise_m + 2 * near.spacing_m);
    const double farthest = std::min(0.7 * depth, 1.8 * near.noise_m + near.spacing_m);
    // Beams along the edge come from two sides of the site, at two times; what the heading has drifted in
    // between displaces them against each other, and their common end would be the outer one. Each side has
    // its own end; the mean of both moves as that of the opposite edge does.
    const double start = -depth;
    const double step = 0.05 * near.noise_m + 1e-4;
    constexpr double kLeastInside = 15;
    std::vector<End> ends;
    std::size_t used = 0;
    for (const double most : {0.25, 0.4, 0.6, 0.9}) {
        ends.clear();
        used = 0;
        for (const double side : {-1.0, 1.0}) {
            std::vector<Seen> seen;
            double inside = 0;
            for (const FitPoint& point : near.points) {
                if (point.range_m <= 0 || side * point.beam.dot(about.direction) < 0) continue;
                // The upper part of the flank, which half of the beams see too, lies under the surface.
                const double above = plane.distance(point.position) * up;
                if (above > reach || above < -0.5 * reach) continue;
                const Eigen::Vector3d from = point.position - about.point;
                const double place = out.dot(from);
                if (place < start || place > stop || std::abs(about.direction.dot(from)) > half) continue;
                const double blur = near.blur_m(point, out);
                if (blur > most * near.noise_m) continue;
                const double share = *whole > 0 ? std::min(1.0, point.energy / *whole) : 1;
                seen.push_back({place, std::max(blur, 0.001), share});
                if (place < 0) inside += share;
            }
            if (inside < kLeastInside) continue;
            const auto end = likeliest(seen, start, stop, farthest, step);
            if (!end) continue;
            ends.push_back(*end);
            used += seen.size();
        }
        if (ends.size() == 2) break;
    }
    if (ends.empty()) return std::nullopt;
    double best = 0;
    double spread = 0;
    for (const End& end : ends) {
        best += end.place / static_cast<double>(ends.size());
        spread += end.spread * end.spread;
    }
    spread = std::sqrt(spread) / static_cast<double>(ends.size());
    // Seen from one side alone, the edge stands where the heading had it then, its counterpart perhaps not.
    if (ends.size() == 1) spread = std::hypot(spread, near.noise_m);
    LineFit line = about;
    line.point += best * out;
    line.inliers = used;
    const double along = near.spacing_m * near.spacing_m / 12;
    line.covariance = spread * spread * out * out.transpose() +
                      plane.varianceAt(line.point) * plane.normal * plane.normal.transpose() +
                      along * about.direction * about.direction.transpose();
    return line;
}

}  // namespace vestige
