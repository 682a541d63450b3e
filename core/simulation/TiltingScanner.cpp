#include "core/simulation/TiltingScanner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/Parallel.h"
#include "core/base/Random.h"

namespace vestige {
namespace {

constexpr std::uint64_t kLineStreams = std::uint64_t{1} << 50;
constexpr double kOrdinaryIntensity = 4000;  // the device's counts for a white target close by

struct Ray {
    double range_m;
    double energy;
};

/// What one beam brings back: the mean range of its strongest group of rays.
class Beam {
  public:
    Beam(const RayTracer& tracer, const SurfaceModel& surfaces, const TiltingLidarSheet& sheet)
        : tracer_(tracer), surfaces_(surfaces), sheet_(sheet) {}

    /// `scannerAxes`: columns are the beam and two directions across it, world frame.
    std::optional<Ray> answer(const Eigen::Vector3d& from, const Eigen::Matrix3d& axes) const {
        // The ray at the half-power circle weighs half of the one in the middle.
        const double aside = 0.5 * sheet_.divergence_rad;
        std::array<Ray, 5> rays{};
        std::size_t count = 0;
        const auto send = [&](double right, double up, double weight) {
            const Eigen::Vector3d to = axes * Eigen::Vector3d(1, right * aside, up * aside);
            if (const auto ray = cast(from, to.normalized()))
                rays[count++] = {ray->range_m, weight * ray->energy};
        };
        send(0, 0, 1);
        send(0.7, 0.7, 0.5);
        send(-0.7, -0.7, 0.5);
        if (count == 3 && spread(rays, 3) < 0.2 * sheet_.rangeResolution_m) return mean(rays.data(), 3, 2);
        send(0.7, -0.7, 0.5);
        send(-0.7, 0.7, 0.5);
        return strongest(rays, count);
    }

  private:
    std::optional<Ray> cast(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
        const auto hit =
            tracer_.cast(from.cast<float>(), direction.cast<float>(), static_cast<float>(sheet_.nearest_m),
                         static_cast<float>(sheet_.farthest_m));
        if (!hit) return std::nullopt;
        const Optics& optics = opticsOf(surfaces_.faces[hit->face].material);
        const double facing = std::abs(tracer_.normal(hit->face).cast<double>().dot(direction));
        return Ray{static_cast<double>(hit->distance), optics.reflectance905 * optics.returns * facing};
    }

    static double spread(const std::array<Ray, 5>& rays, std::size_t count) {
        double least = rays[0].range_m, most = rays[0].range_m;
        for (std::size_t i = 1; i < count; ++i) {
            least = std::min(least, rays[i].range_m);
            most = std::max(most, rays[i].range_m);
        }
        return most - least;
    }

    /// `sent`: sum of the weights of all rays of the beam.
    static Ray mean(const Ray* rays, std::size_t count, double sent) {
        Ray all{0, 0};
        for (std::size_t i = 0; i < count; ++i) {
            all.range_m += rays[i].energy * rays[i].range_m;
            all.energy += rays[i].energy;
        }
        if (all.energy > 0) all.range_m /= all.energy;
        all.energy /= sent;
        return all;
    }

    std::optional<Ray> strongest(std::array<Ray, 5>& rays, std::size_t count) const {
        for (std::size_t i = 1; i < count; ++i)
            for (std::size_t k = i; k > 0 && rays[k].range_m < rays[k - 1].range_m; --k)
                std::swap(rays[k], rays[k - 1]);
        std::optional<Ray> best;
        for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
            for (end = begin + 1;
                 end < count && rays[end].range_m - rays[end - 1].range_m < sheet_.rangeResolution_m;)
                ++end;
            const Ray group = mean(rays.data() + begin, end - begin, 3);
            if (!best || group.energy > best->energy) best = group;
        }
        return best;
    }

    const RayTracer& tracer_;
    const SurfaceModel& surfaces_;
    const TiltingLidarSheet& sheet_;
};

double noiseAt(const TiltingLidarSheet& sheet, double range_m) {
    const double share =
        std::clamp((range_m - sheet.nearEnd_m) / (sheet.farthest_m - sheet.nearEnd_m), 0.0, 1.0);
    return sheet.noiseNear_m + share * (sheet.noiseFar_m - sheet.noiseNear_m);
}

}  // namespace

Result<std::vector<TiltedPoint>> scanTilting(const RayTracer& tracer, const SurfaceModel& surfaces,
                                             const TiltingLidarSheet& sheet, const TiltingOptions& options,
                                             const JobControl& control) {
    const double tilted = options.tiltTo_rad - options.tiltFrom_rad;
    const double step = std::sqrt(tilted * sheet.fieldOfView_rad / static_cast<double>(options.beams));
    const auto lines = static_cast<std::size_t>(std::max(2.0, std::round(tilted / step)));
    const auto beams = static_cast<std::size_t>(std::max(2.0, std::round(sheet.fieldOfView_rad / step)));
    const Beam beam(tracer, surfaces, sheet);
    const Eigen::Vector3d from = options.worldFromScanner.translation();
    std::vector<std::vector<TiltedPoint>> found(lines);
    parallelFor(lines, 1, [&](std::size_t begin, std::size_t end) {
        if (control.cancelled()) return;
        for (std::size_t line = begin; line < end; ++line) {
            Random random(options.seed, kLineStreams + (options.number << 20) + line);
            const double tilt = options.tiltFrom_rad +
                                (static_cast<double>(line) + 0.5) / static_cast<double>(lines) * tilted;
            const double start_s = static_cast<double>(line) / sheet.linesPerSecond;
            const Eigen::Matrix3d plane =
                Eigen::AngleAxisd(-tilt, Eigen::Vector3d::UnitY()).toRotationMatrix();
            for (std::size_t i = 0; i < beams; ++i) {
                const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(beams);
                const double angle = (share - 0.5) * sheet.fieldOfView_rad;
                Eigen::Matrix3d scannerAxes =
                    plane * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
                const double chance = random.uniform();
                const double anywhere = random.uniform(sheet.nearest_m, sheet.farthest_m);
                const double noise = random.normal();
                auto ray = beam.answer(from, options.worldFromScanner.linear() * scannerAxes);
                if (ray) {
                    const double faintest = sheet.leastReflectance * ray->range_m * ray->range_m /
                                            (sheet.farthest_m * sheet.farthest_m);
                    if (ray->energy < faintest) ray.reset();
                }
                if (chance < options.falseRanges) ray = Ray{anywhere, 0.02};
                if (!ray) continue;
                const double range = ray->range_m + noise * noiseAt(sheet, ray->range_m);
                found[line].push_back(
                    {range * scannerAxes.col(0),
                     static_cast<float>(std::round(kOrdinaryIntensity * std::min(1.0, ray->energy))),
                     start_s + share / sheet.linesPerSecond, static_cast<std::uint16_t>(line),
                     static_cast<std::uint16_t>(i)});
            }
        }
    });
    if (control.cancelled()) return fail(cancelledError());
    std::vector<TiltedPoint> points;
    for (const auto& line : found) points.insert(points.end(), line.begin(), line.end());
    return points;
}

}  // namespace vestige
