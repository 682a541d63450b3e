#include "core/filters/Outliers.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Parallel.h"
#include "core/filters/LoopProgress.h"
#include "core/filters/NearbyPoints.h"
#include "core/filters/Spacing.h"
#include "core/geometry/NeighbourLists.h"

namespace vestige {
namespace {

/// For every point, the mean distance to its `count` nearest others.
std::vector<float> neighbourDistances(const PointCloud& cloud, std::size_t count, const JobControl& control) {
    const NeighbourIndex index(cloud.offsets());
    LoopProgress progress(control, cloud.size(), "outliers");
    std::vector<float> distances(cloud.size(), 0);
    const std::size_t others = std::min(count, cloud.size() - 1);
    forNearestDistances(
        index, others + 1,
        [&](const NearestDistances& nearest) {
            // The first is the point itself, or one that coincides with it. Nearest first, lane by lane.
            __m256d low{};
            __m256d high{};
            for (const auto& row : nearest.squared.subspan(1)) {
                low = _mm256_add_pd(low, _mm256_sqrt_pd(_mm256_cvtps_pd(_mm_loadu_ps(row.data()))));
                high = _mm256_add_pd(high, _mm256_sqrt_pd(_mm256_cvtps_pd(_mm_loadu_ps(row.data() + 4))));
            }
            std::array<double, 8> sums;
            _mm256_storeu_pd(sums.data(), low);
            _mm256_storeu_pd(sums.data() + 4, high);
            for (std::size_t lane = 0; lane < nearest.points.size(); ++lane)
                distances[nearest.points[lane]] =
                    static_cast<float>(sums[lane] / static_cast<double>(others));
        },
        [&](std::size_t points) { progress.done(points); });
    return distances;
}

/// mean + sigmas * SD (n - 1) of the values.
double statisticalLimit(const std::vector<float>& values, double sigmas) {
    const auto size = static_cast<double>(values.size());
    const auto sumOf = [&](const auto& term) {
        return parallelSum(values.size(), 65536, 0.0, [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i) sum += term(static_cast<double>(values[i]));
            return sum;
        });
    };
    const double mean = sumOf([](double value) { return value; }) / size;
    const double squares = sumOf([&](double value) { return (value - mean) * (value - mean); });
    return mean + sigmas * std::sqrt(squares / (size - 1));
}

/// 1 for each point that stays.
using Kept = std::vector<std::uint8_t>;

Kept withoutStatistical(const PointCloud& cloud, const OutlierOptions& options, const JobControl& control) {
    const auto distances = neighbourDistances(cloud, static_cast<std::size_t>(options.neighbours), control);
    const double limit = statisticalLimit(distances, options.sigmas);
    Kept keep(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) keep[i] = static_cast<double>(distances[i]) <= limit;
    return keep;
}

Kept withoutLonely(const PointCloud& cloud, const OutlierOptions& options, const JobControl& control) {
    const double radius = options.radius > 0 ? options.radius : automaticRadius(cloud);
    // Points that all coincide have all the neighbours one can ask for.
    if (radius < kLeastRadius) return Kept(cloud.size(), 1);
    const auto single = static_cast<float>(radius);
    const auto needed = static_cast<std::size_t>(options.minimumNeighbours) + 1;  // itself is found too
    Kept keep(cloud.size(), 0);
    forNearbyPoints(cloud, radius, "outliers", control, [&](const NearbyPoints& nearby) {
        for (std::size_t i = 0; i < nearby.own.size(); ++i) {
            const std::size_t self = nearby.firstOwn + i;
            std::size_t within = 0;
            for (std::size_t at = 0; at < nearby.count && within < needed; ++at) {
                const float dx = nearby.x[at] - nearby.x[self];
                const float dy = nearby.y[at] - nearby.y[self];
                const float dz = nearby.z[at] - nearby.z[self];
                within += dx * dx + dy * dy + dz * dz <= single * single;
            }
            keep[nearby.own[i]] = within >= needed;
        }
    });
    return keep;
}

std::vector<std::uint32_t> indicesOf(const Kept& kept, bool wanted) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < kept.size(); ++i)
        if ((kept[i] != 0) == wanted) indices.push_back(i);
    return indices;
}

Result<Kept> withoutOutliers(const PointCloud& cloud, const OutlierOptions& options,
                             const JobControl& control) {
    if (options.neighbours < 1 || options.minimumNeighbours < 1)
        return fail(ErrorCode::usage, "outliers need a number of neighbours of at least 1", "outliers");
    if (!(options.sigmas >= 0) || !std::isfinite(options.sigmas))
        return fail(ErrorCode::usage,
                    "the limit of " + exactText(options.sigmas) + " standard deviations is not allowed",
                    "outliers", "expected a number from 0 up");
    if (const Status checked = checkRadius(options.radius); !checked) return fail(checked.error());
    return guarded("outliers", [&]() -> Result<Kept> {
        return options.method == OutlierMethod::statistical ? withoutStatistical(cloud, options, control)
                                                            : withoutLonely(cloud, options, control);
    });
}

}  // namespace

Result<PointCloud> removeOutliers(const PointCloud& cloud, const OutlierOptions& options,
                                  const JobControl& control) {
    if (options.method == OutlierMethod::none || cloud.size() < 2) return cloud;
    const auto kept = withoutOutliers(cloud, options, control);
    if (!kept) return fail(kept.error());
    return guarded("outliers", [&]() -> Result<PointCloud> { return cloud.select(indicesOf(*kept, true)); });
}

Result<std::vector<std::uint32_t>> findOutliers(const PointCloud& cloud, const OutlierOptions& options,
                                                const JobControl& control) {
    if (options.method == OutlierMethod::none || cloud.size() < 2) return std::vector<std::uint32_t>();
    const auto kept = withoutOutliers(cloud, options, control);
    if (!kept) return fail(kept.error());
    return indicesOf(*kept, false);
}

}  // namespace vestige
