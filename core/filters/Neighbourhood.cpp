#include "core/filters/Neighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/filters/NearbyPoints.h"
#include "core/filters/Spacing.h"
#include "core/filters/WorldPoints.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

constexpr std::size_t kLanes = NearbyPoints::kLanes;
/// Four numbers that the processor handles at once (a vector type of GCC and Clang; the compilers' own
/// vectorisers leave the loop below alone, as a comparison might trap).
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));

inline Lanes lanesAt(std::span<const float> values, std::size_t at) {
    Lanes lanes;
    std::memcpy(&lanes, values.data() + at, sizeof lanes);
    return lanes;
}

/// exp(-2 t) for t from 0 to 1 to about 1e-6, from operations that round alike on every machine: the series
/// of exp(-t / 8), whose 16th power it is.
inline Lanes gaussianWeight(Lanes t) {
    const Lanes u = t * 0.125F;
    const Lanes root = 1.0F - u * (1.0F - u * (0.5F - u * (1.0F / 6 - u * (1.0F / 24 - u * (1.0F / 120)))));
    const Lanes square = root * root;
    const Lanes fourth = square * square;
    const Lanes eighth = fourth * fourth;
    return eighth * eighth;
}

/// From own point i to the weighted mean of all points within the radius.
template <class Weight>
Eigen::Vector3d shiftToMean(const NearbyPoints& nearby, std::size_t i, float squaredRadius,
                            const Weight& weightOf) {
    const std::size_t self = nearby.firstOwn + i;
    const Lanes none{};
    Lanes weights{};
    Lanes sumX{};
    Lanes sumY{};
    Lanes sumZ{};
    for (std::size_t at = 0; at < nearby.x.size(); at += kLanes) {
        const Lanes dx = lanesAt(nearby.x, at) - nearby.x[self];
        const Lanes dy = lanesAt(nearby.y, at) - nearby.y[self];
        const Lanes dz = lanesAt(nearby.z, at) - nearby.z[self];
        const Lanes squared = dx * dx + dy * dy + dz * dz;
        const Lanes weight = squared <= squaredRadius ? weightOf(squared) : none;
        weights += weight;
        sumX += weight * dx;
        sumY += weight * dy;
        sumZ += weight * dz;
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
    const WorldPoints world(cloud);
    PointCloudBuilder builder(cloud.origin());
    builder.resize(cloud.size());
    forNearbyPoints(cloud, radius, "filter", control, [&](const NearbyPoints& nearby) {
        Eigen::Vector3d last = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < nearby.own.size(); ++i) {
            // Scanners write thousands of lost points to one place; their answer is asked for once.
            if (i == 0 || !nearby.coincide(i, i - 1)) last = shift(nearby, i);
            builder.setPoint(nearby.own[i], world[nearby.own[i]] + last);
        }
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
                                 return shiftToMean(nearby, i, squaredRadius, [scale](Lanes squared) {
                                     return gaussianWeight(squared * scale);
                                 });
                             });
            case NeighbourhoodFilter::mean:
            case NeighbourhoodFilter::none:
                break;
        }
        return moved(cloud, radius, control, [&](const NearbyPoints& nearby, std::size_t i) {
            return shiftToMean(nearby, i, squaredRadius, [](Lanes) { return Lanes{} + 1.0F; });
        });
    });
}

}  // namespace vestige
