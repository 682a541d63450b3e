#include "core/filters/Neighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/filters/NearbyPoints.h"
#include "core/filters/Spacing.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

constexpr std::size_t kLanes = NearbyPoints::kLanes;

/// exp(-2 t) for t from 0 to 1 to about 1e-6, from operations that round alike on every machine: the series
/// of exp(-t / 8), whose 16th power it is.
inline float gaussianWeight(float t) {
    const float u = t * 0.125F;
    const float root = 1.0F - u * (1.0F - u * (0.5F - u * (1.0F / 6 - u * (1.0F / 24 - u * (1.0F / 120)))));
    const float square = root * root;
    const float fourth = square * square;
    const float eighth = fourth * fourth;
    return eighth * eighth;
}

/// From own point i to the weighted mean of all points within the radius. Summed in lanes, which the compiler
/// can run side by side, and the lanes in order.
template <class Weight>
Eigen::Vector3d shiftToMean(const NearbyPoints& nearby, std::size_t i, float squaredRadius,
                            const Weight& weightOf) {
    const std::size_t self = nearby.firstOwn + i;
    const float x = nearby.x[self];
    const float y = nearby.y[self];
    const float z = nearby.z[self];
    std::array<float, kLanes> weights{};
    std::array<float, kLanes> sumX{};
    std::array<float, kLanes> sumY{};
    std::array<float, kLanes> sumZ{};
    for (std::size_t at = 0; at < nearby.x.size(); at += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const float dx = nearby.x[at + lane] - x;
            const float dy = nearby.y[at + lane] - y;
            const float dz = nearby.z[at + lane] - z;
            const float squared = dx * dx + dy * dy + dz * dz;
            const float weight = squared <= squaredRadius ? weightOf(squared) : 0.0F;
            weights[lane] += weight;
            sumX[lane] += weight * dx;
            sumY[lane] += weight * dy;
            sumZ[lane] += weight * dz;
        }
    }
    double weight = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        weight += static_cast<double>(weights[lane]);
        sum += Eigen::Vector3f(sumX[lane], sumY[lane], sumZ[lane]).cast<double>();
    }
    return sum / weight;
}

/// The middle value, or the mean of the two middle ones; reorders `values`.
double median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    const auto upper = static_cast<double>(*middle);
    if (values.size() % 2 == 1) return upper;
    return 0.5 * (upper + static_cast<double>(*std::max_element(values.begin(), middle)));
}

Eigen::Vector3d shiftToMedian(const NearbyPoints& nearby, std::size_t i, float squaredRadius) {
    thread_local std::array<std::vector<float>, 3> within;
    for (auto& axis : within) axis.clear();
    const std::size_t self = nearby.firstOwn + i;
    for (std::size_t at = 0; at < nearby.count; ++at) {
        const float dx = nearby.x[at] - nearby.x[self];
        const float dy = nearby.y[at] - nearby.y[self];
        const float dz = nearby.z[at] - nearby.z[self];
        if (dx * dx + dy * dy + dz * dz > squaredRadius) continue;
        within[0].push_back(dx);
        within[1].push_back(dy);
        within[2].push_back(dz);
    }
    return {median(within[0]), median(within[1]), median(within[2])};
}

/// Moves every point by shift(nearby, i).
template <class Shift>
PointCloud moved(const PointCloud& cloud, double radius, const JobControl& control, const Shift& shift) {
    PointCloudBuilder builder(cloud.origin());
    builder.resize(cloud.size());
    forNearbyPoints(cloud, radius, "filter", control, [&](const NearbyPoints& nearby) {
        for (std::size_t i = 0; i < nearby.own.size(); ++i)
            builder.setPoint(nearby.own[i], cloud.point(nearby.own[i]) + shift(nearby, i));
    });
    builder.attributes() = cloud.attributes();
    return std::move(builder).build();
}

}  // namespace

Result<PointCloud> filterNeighbourhood(const PointCloud& cloud, const NeighbourhoodOptions& options,
                                       const JobControl& control) {
    if (options.filter == NeighbourhoodFilter::none) return cloud;
    if (const Status checked = checkRadius(options.radius); !checked) return fail(checked.error());
    return guarded("filter", [&]() -> Result<PointCloud> {
        const double radius = options.radius > 0 ? options.radius : automaticRadius(cloud);
        // All points coincide with their neighbours: each is its own mean already.
        if (radius < kLeastRadius) return cloud;
        const auto single = static_cast<float>(radius);
        const float squaredRadius = single * single;
        switch (options.filter) {
            case NeighbourhoodFilter::median:
                return moved(cloud, radius, control, [&](const NearbyPoints& nearby, std::size_t i) {
                    return shiftToMedian(nearby, i, squaredRadius);
                });
            case NeighbourhoodFilter::gaussian:
                return moved(cloud, radius, control,
                             [&, scale = 1 / squaredRadius](const NearbyPoints& nearby, std::size_t i) {
                                 return shiftToMean(nearby, i, squaredRadius, [scale](float squared) {
                                     return gaussianWeight(squared * scale);
                                 });
                             });
            case NeighbourhoodFilter::mean:
            case NeighbourhoodFilter::none:
                break;
        }
        return moved(cloud, radius, control, [&](const NearbyPoints& nearby, std::size_t i) {
            return shiftToMean(nearby, i, squaredRadius, [](float) { return 1.0F; });
        });
    });
}

}  // namespace vestige
