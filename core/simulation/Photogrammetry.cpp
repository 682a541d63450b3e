#include "core/simulation/Photogrammetry.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/simulation/NightLight.h"
#include "core/simulation/PointThinning.h"

namespace vestige {
namespace {

constexpr int kCameras = 16;
constexpr double kStep_rad = 0.2;  ///< between photographs that are matched with each other
constexpr std::uint64_t kFrameStream = 300;
constexpr std::uint64_t kRowStreams = std::uint64_t{1} << 44;
constexpr std::uint64_t kLatticeStreams = std::uint64_t{1} << 46;

/// A smooth random field of unit sigma: normal values on a lattice, blended linearly and rescaled so that the
/// blend keeps the sigma on average.
class SmoothField {
  public:
    SmoothField(std::uint64_t seed, std::uint64_t number, double cell)
        : seed_(seed), number_(number), cell_(cell) {}
    double at(double x, double y) const {
        const double u = x / cell_;
        const double v = y / cell_;
        const auto i = static_cast<std::int64_t>(std::floor(u));
        const auto j = static_cast<std::int64_t>(std::floor(v));
        const double a = u - static_cast<double>(i);
        const double b = v - static_cast<double>(j);
        const std::array<double, 4> weight{(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
        double sum = 0;
        double squares = 0;
        for (std::int64_t k = 0; k < 4; ++k) {
            const double w = weight[static_cast<std::size_t>(k)];
            sum += w * value(i + k % 2, j + k / 2);
            squares += w * w;
        }
        return sum / std::sqrt(squares);
    }

  private:
    double value(std::int64_t i, std::int64_t j) const {
        const auto cell = static_cast<std::uint64_t>((i + 50000) * 100000 + j + 50000);
        return Random(seed_ + number_ * 7919, kLatticeStreams + cell).normal();
    }
    std::uint64_t seed_;
    std::uint64_t number_;
    double cell_;
};

struct Matched {
    Eigen::Vector3f truth;
    Eigen::Vector3f measured;
    Color color;
    std::uint16_t part;
};

struct Setup {
    const RayTracer& tracer;
    const SurfaceModel& surfaces;
    const CircularFlight& flight;
    double reach, spacing, noise, patch, fineNoise;
};

Eigen::Vector3d cameraAt(const CircularFlight& flight, double angle) {
    return flight.target + Eigen::Vector3d(flight.radius_m * std::cos(angle),
                                           flight.radius_m * std::sin(angle), flight.height_m);
}

/// One row of one photograph's raster over the ground of the site.
void matchRow(const Setup& setup, int camera, int row, int columns, const SmoothField& field, Random& random,
              std::vector<Matched>& found) {
    const double angle = 2 * std::numbers::pi * camera / kCameras;
    const Eigen::Vector3d from = cameraAt(setup.flight, angle);
    const Eigen::Vector3f fromF = from.cast<float>();
    const std::array<Eigen::Vector3f, 2> partners{cameraAt(setup.flight, angle - kStep_rad).cast<float>(),
                                                  cameraAt(setup.flight, angle + kStep_rad).cast<float>()};
    const double pixel = 2 * setup.spacing;
    for (int column = 0; column < columns; ++column) {
        const Eigen::Vector3d ground =
            setup.flight.target + Eigen::Vector3d((column + random.uniform()) * pixel - setup.reach,
                                                  (row + random.uniform()) * pixel - setup.reach, 0);
        // The matching window answers with the range of some pixel within it.
        const Eigen::Vector3d matched =
            ground + 1.5 * setup.spacing * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 0);
        const double chance = random.uniform();
        const double fine = random.normal(0, setup.fineNoise);
        const Eigen::Vector3d direction = (ground - from).normalized();
        const Eigen::Vector3d ray = (matched - from).normalized();
        const auto hit = setup.tracer.cast(fromF, ray.cast<float>(), 0.5F, 200);
        if (!hit) continue;
        const Face& face = setup.surfaces.faces[hit->face];
        const Optics& optics = opticsOf(face.material);
        const Eigen::Vector3d place = from + static_cast<double>(hit->distance) * ray;
        const double light =
            nightLight(setup.surfaces.lights, place, setup.tracer.normal(hit->face).cast<double>());
        const double signal = light * (optics.color[0] + optics.color[1] + optics.color[2]) / 3;
        if (chance > optics.cameraFinds * signal / (signal + 0.01)) continue;
        const Eigen::Vector3f placeF = place.cast<float>();
        if (!setup.tracer.sees(partners[0], placeF, 0.02F)) continue;
        if (!setup.tracer.sees(partners[1], placeF, 0.02F)) continue;
        const double range =
            static_cast<double>(hit->distance) + setup.noise * field.at(ground.x(), ground.y()) + fine;
        found.push_back(
            {placeF, (from + range * direction).cast<float>(), nightColor(optics, light), face.part});
    }
}

}  // namespace

Result<PhotogrammetryScan> photographScene(const RayTracer& tracer, const SurfaceModel& surfaces,
                                           const CircularFlight& flight, const ParameterSet& parameters,
                                           const Eigen::Vector3d& worldFromSite, std::uint64_t seed,
                                           const ProbeCounter& probes, const JobControl& control) {
    const Setup setup{tracer,
                      surfaces,
                      flight,
                      parameters.real("reach_m"),
                      parameters.real("spacing_m"),
                      parameters.real("noise_m"),
                      parameters.real("patch_m"),
                      parameters.real("fine_noise_m")};
    const int side = std::max(1, static_cast<int>(std::lround(setup.reach / setup.spacing)));
    const auto rows = static_cast<std::size_t>(kCameras) * static_cast<std::size_t>(side);
    std::vector<std::vector<Matched>> byRow(rows);
    parallelFor(rows, 8, [&](std::size_t begin, std::size_t end) {
        if (control.cancelled()) return;
        for (std::size_t i = begin; i < end; ++i) {
            const int camera = static_cast<int>(i) / side;
            Random random(seed, kRowStreams + i);
            matchRow(setup, camera, static_cast<int>(i) % side, side,
                     SmoothField(seed, static_cast<std::uint64_t>(camera), setup.patch), random, byRow[i]);
        }
    });
    if (control.cancelled()) return fail(cancelledError());
    std::vector<Matched> all;
    std::vector<Eigen::Vector3f> positions;
    for (const std::vector<Matched>& row : byRow)
        for (const Matched& one : row) {
            all.push_back(one);
            positions.push_back(one.measured);
        }
    PhotogrammetryScan scan;
    scan.probeCounts = probes.zeroes();
    Random random(seed, kFrameStream);
    const double scale = 1 + random.normal(0, parameters.real("scale_sigma"));
    const double sigma = parameters.real("shift_sigma_m");
    const Eigen::Vector3d shift(random.normal(0, sigma), random.normal(0, sigma), random.normal(0, sigma));
    const Eigen::Vector3d middle = flight.target;
    PointCloudBuilder builder((worldFromSite + middle).array().round().matrix());
    for (const std::uint32_t i : firstPerCell(positions, setup.spacing)) {
        const Matched& one = all[i];
        builder.add(worldFromSite + middle + scale * (one.measured.cast<double>() - middle) + shift);
        builder.attributes().color.push_back(one.color);
        probes.count(one.truth, one.part, scan.probeCounts);
    }
    scan.siteFromLayer.scale = 1 / scale;
    scan.siteFromLayer.pose.translation() = middle - (worldFromSite + middle + shift) / scale;
    scan.cloud = std::move(builder).build();
    return scan;
}

}  // namespace vestige
