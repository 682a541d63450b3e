#include "core/simulation/Footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vestige {
namespace {

constexpr std::size_t kRays = 7;
constexpr std::size_t kMiddle = 3;
/// Position across the spot in half widths, the power there (0.5 at the half-power width) and side of the
/// spot.
constexpr std::array<double, kRays> kAlong{-1, -2.0 / 3, -1.0 / 3, 0, 1.0 / 3, 2.0 / 3, 1};
constexpr std::array<double, kRays> kAcross{0.5, -0.5, 0.5, 0, -0.5, 0.5, -0.5};

std::array<double, kRays> weights() {
    std::array<double, kRays> all{};
    double sum = 0;
    for (std::size_t i = 0; i < kRays; ++i) sum += all[i] = std::exp2(-kAlong[i] * kAlong[i]);
    for (double& one : all) one /= sum;
    return all;
}

const std::array<double, kRays> kWeight = weights();

}  // namespace

Footprint::Footprint(const RayTracer& tracer, const SurfaceModel& surfaces, const AirborneLidarSheet& sheet)
    : tracer_(tracer), surfaces_(surfaces), sheet_(sheet) {}

Footprint::Ray Footprint::castRay(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                  Random& random) const {
    const Eigen::Vector3f start = from.cast<float>();
    const Eigen::Vector3f along = direction.cast<float>();
    Ray ray;
    ray.plain = true;
    float nearest = 0.5F;
    constexpr int kSurfaces = 6;
    for (int surface = 0; surface < kSurfaces; ++surface) {
        const auto hit = tracer_.cast(start, along, nearest, 400);
        if (!hit) return ray;
        const Face& face = surfaces_.faces[hit->face];
        const Optics& optics = opticsOf(face.material);
        const bool simple = optics.returns == 1;
        const double chance = simple ? 0 : random.uniform();
        if (chance < optics.returns) {
            const double cosine = std::abs(static_cast<double>(tracer_.normal(hit->face).dot(along)));
            ray.range_m = static_cast<double>(hit->distance);
            ray.energy = optics.reflectance905 * cosine;
            ray.truth = start + hit->distance * along;
            ray.part = face.part;
            ray.plain = ray.plain && simple;
            ray.hit = true;
            return ray;
        }
        ray.plain = false;
        if (chance > optics.returns + optics.passes) return ray;
        nearest = hit->distance + 1e-3F;
    }
    return ray;
}

void Footprint::echoes(const Eigen::Vector3d& from, const Eigen::Matrix3d& siteFromBeam, Random& random,
                       std::vector<Echo>& found) const {
    found.clear();
    std::array<Ray, kRays> rays;
    const auto cast = [&](std::size_t i) {
        const Eigen::Vector3d direction = siteFromBeam.col(0) +
                                          0.5 * sheet_.divergenceLong_rad * kAlong[i] * siteFromBeam.col(1) +
                                          0.5 * sheet_.divergenceShort_rad * kAcross[i] * siteFromBeam.col(2);
        rays[i] = castRay(from, direction.normalized(), random);
    };
    for (const std::size_t i : {kMiddle, std::size_t{0}, kRays - 1}) cast(i);
    const Ray& a = rays.front();
    const Ray& middle = rays[kMiddle];
    const Ray& b = rays.back();
    const bool even = a.plain && b.plain && middle.plain && a.hit && b.hit && middle.hit &&
                      a.part == middle.part && b.part == middle.part &&
                      std::abs(a.range_m - 2 * middle.range_m + b.range_m) < 0.004 &&
                      std::abs(a.range_m - b.range_m) < sheet_.rangeResolution_m;
    const double least =
        0.1 * middle.range_m * middle.range_m / (sheet_.rangeAtTenPercent_m * sheet_.rangeAtTenPercent_m);
    if (even) {
        if (middle.energy > least)
            found.push_back({middle.range_m, middle.energy, middle.truth, middle.part});
        return;
    }
    for (const std::size_t i : {1U, 2U, 4U, 5U}) cast(i);

    // Indices of the rays that met something, nearest first.
    std::array<std::size_t, kRays> order{};
    std::size_t hits = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
        if (!rays[i].hit) continue;
        std::size_t place = hits++;
        for (; place > 0 && rays[order[place - 1]].range_m > rays[i].range_m; --place)
            order[place] = order[place - 1];
        order[place] = i;
    }
    double strongest = 0;
    for (std::size_t k = 0; k < hits; ++k) {
        const Ray& ray = rays[order[k]];
        const double energy = kWeight[order[k]] * ray.energy;
        if (k == 0 || ray.range_m - rays[order[k - 1]].range_m > sheet_.rangeResolution_m) {
            found.push_back({});
            strongest = -1;
        }
        Echo& echo = found.back();
        if (energy > strongest) {
            strongest = energy;
            echo.truth = ray.truth;
            echo.part = ray.part;
        }
        const double sum = echo.energy + energy;
        if (sum > 0) echo.range_m += (ray.range_m - echo.range_m) * energy / sum;
        echo.energy = sum;
    }
    std::erase_if(found, [&](const Echo& echo) {
        const double ratio = echo.range_m / sheet_.rangeAtTenPercent_m;
        return echo.energy <= 0.1 * ratio * ratio;
    });
    while (found.size() > static_cast<std::size_t>(sheet_.maxReturns))
        found.erase(std::min_element(found.begin(), found.end(),
                                     [](const Echo& l, const Echo& r) { return l.energy < r.energy; }));
}

}  // namespace vestige
