#include "core/simulation/AerialScanner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>

#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/simulation/Footprint.h"

namespace vestige {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::uint64_t kErrorStreams = 100;
/// Pulse p draws from stream kPulseStreams + p.
constexpr std::uint64_t kPulseStreams = std::uint64_t{1} << 32;

/// An error that changes slowly: three sines with periods of 7 to 60 s, together of the given sigma.
class SlowError {
  public:
    SlowError(std::uint64_t seed, std::uint64_t stream, double sigma)
        : amplitude_(sigma * std::sqrt(2.0 / 3)) {
        Random random(seed, kErrorStreams + stream);
        for (Wave& wave : waves_) wave = {kTurn / random.uniform(7, 60), random.uniform(0, kTurn)};
    }
    double at(double t_s) const {
        double sum = 0;
        for (const Wave& wave : waves_) sum += std::sin(wave.frequency * t_s + wave.phase);
        return amplitude_ * sum;
    }

  private:
    struct Wave {
        double frequency = 0;
        double phase = 0;
    };
    double amplitude_;
    std::array<Wave, 3> waves_;
};

/// What the navigation unit says instead of the truth.
struct Navigation {
    Navigation(const AirborneLidarSheet& sheet, std::uint64_t seed)
        : errors{
              SlowError(seed, 0, sheet.positionHorizontal_m), SlowError(seed, 1, sheet.positionHorizontal_m),
              SlowError(seed, 2, sheet.positionVertical_m),   SlowError(seed, 3, sheet.rollPitch_rad),
              SlowError(seed, 4, sheet.rollPitch_rad),        SlowError(seed, 5, sheet.yaw_rad)} {}
    std::array<SlowError, 6> errors;

    Eigen::Vector3d shift(double t) const { return {errors[0].at(t), errors[1].at(t), errors[2].at(t)}; }
    Eigen::Vector3d turn(double t) const { return {errors[3].at(t), errors[4].at(t), errors[5].at(t)}; }
};

struct Measured {
    Eigen::Vector3f position;  ///< site frame
    float intensity;
    double time_s;
    std::uint8_t number;
    std::uint8_t count;
};

struct Chunk {
    std::vector<Measured> points;
    std::vector<std::uint32_t> probeCounts;
};

PointCloud assemble(const std::vector<Chunk>& chunks, const AerialOptions& options) {
    std::size_t count = 0;
    for (const Chunk& chunk : chunks) count += chunk.points.size();
    PointCloudBuilder builder((options.worldFromSite + options.flight.target).array().round().matrix());
    builder.reserve(count);
    PointAttributes& attributes = builder.attributes();
    attributes.intensity.reserve(count);
    attributes.gpsTime.reserve(count);
    attributes.returnNumber.reserve(count);
    attributes.returnCount.reserve(count);
    for (const Chunk& chunk : chunks) {
        for (const Measured& point : chunk.points) {
            builder.add(options.worldFromSite + point.position.cast<double>());
            attributes.intensity.push_back(point.intensity);
            attributes.gpsTime.push_back(options.gpsTime_s + point.time_s);
            attributes.returnNumber.push_back(point.number);
            attributes.returnCount.push_back(point.count);
        }
    }
    return std::move(builder).build();
}

}  // namespace

Eigen::Vector3d beamDirection(const AirborneLidarSheet& sheet, bool repetitive, double t_s) {
    double level = 0;
    double upright = 0;
    if (repetitive) {
        const double sweep = std::abs(2 * (t_s * 24 - std::floor(t_s * 24)) - 1);
        level = 0.5 * sheet.fieldHorizontal_rad * (2 * sweep - 1);
        upright = 0.5 * sheet.fieldVerticalRepetitive_rad * std::sin(kTurn * 1.37 * t_s);
    } else {
        // Two prisms that turn against each other draw a rosette that never closes.
        const double reach = std::sin(kTurn * 777.3 * t_s);
        const double angle = kTurn * 11.13 * t_s;
        level = 0.5 * sheet.fieldHorizontal_rad * reach * std::cos(angle);
        upright = 0.5 * sheet.fieldVertical_rad * reach * std::sin(angle);
    }
    return Eigen::Vector3d(1, std::tan(level), std::tan(upright)).normalized();
}

Result<AerialScan> scanFromAir(const RayTracer& tracer, const SurfaceModel& surfaces,
                               const AirborneLidarSheet& sheet, const AerialOptions& options,
                               const ProbeCounter& probes, const JobControl& control) {
    const auto pulses = static_cast<std::size_t>(std::llround(options.seconds * sheet.pulsesPerSecond));
    const Footprint footprint(tracer, surfaces, sheet);
    const Navigation navigation(sheet, options.seed);
    constexpr std::size_t kGrain = 8192;
    std::vector<Chunk> chunks((pulses + kGrain - 1) / kGrain);
    std::atomic<std::size_t> done = 0;
    parallelChunks(pulses, kGrain, [&](std::size_t index, std::size_t begin, std::size_t end) {
        if (control.cancelled()) return;
        Chunk& chunk = chunks[index];
        chunk.probeCounts = probes.zeroes();
        chunk.points.reserve(end - begin);
        std::vector<Echo> found;
        for (std::size_t pulse = begin; pulse < end; ++pulse) {
            Random random(options.seed, kPulseStreams + pulse);
            const double t = static_cast<double>(pulse) / sheet.pulsesPerSecond;
            const Pose siteFromSensor = options.flight.siteFromSensor(t);
            const Eigen::Vector3d beam = beamDirection(sheet, options.repetitive, t);
            const Eigen::Vector3d across = beam.cross(Eigen::Vector3d::UnitZ()).normalized();
            Eigen::Matrix3d axes;
            axes << beam, across.cross(beam), across;
            axes = siteFromSensor.linear() * axes;
            footprint.echoes(siteFromSensor.translation(), axes, random, found);
            const Eigen::Vector3d shift = navigation.shift(t);
            const Eigen::Vector3d turn = navigation.turn(t);
            for (std::size_t k = 0; k < found.size(); ++k) {
                const Echo& echo = found[k];
                const Eigen::Vector3d ray =
                    (echo.range_m + random.normal(0, sheet.rangeNoise_m)) * axes.col(0);
                const Eigen::Vector3d point = siteFromSensor.translation() + shift + ray + turn.cross(ray);
                chunk.points.push_back(
                    {point.cast<float>(), static_cast<float>(std::min(255.0, std::round(255 * echo.energy))),
                     t, static_cast<std::uint8_t>(k + 1), static_cast<std::uint8_t>(found.size())});
                probes.count(echo.truth, echo.part, chunk.probeCounts);
            }
        }
        const std::size_t now = ++done;
        control.progress(static_cast<double>(now) / static_cast<double>(chunks.size()), "airborne scan");
    });
    if (control.cancelled()) return fail(cancelledError());
    AerialScan scan;
    scan.pulses = pulses;
    scan.probeCounts = probes.zeroes();
    for (const Chunk& chunk : chunks)
        for (std::size_t i = 0; i < scan.probeCounts.size(); ++i) scan.probeCounts[i] += chunk.probeCounts[i];
    scan.cloud = assemble(chunks, options);
    return scan;
}

}  // namespace vestige
