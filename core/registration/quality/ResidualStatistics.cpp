#include "core/registration/quality/ResidualStatistics.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kMostPoints = 20000;
constexpr int kHalfBins = 20;
constexpr double kSigmasPerMad = 1.4826;

/// The next of 1, 2, 5, 10, ... at or above the value.
double roundWidth(double value) {
    double width = 1e-6;
    for (int i = 0; width < value; ++i) width *= i % 3 == 1 ? 2.5 : 2;
    return width;
}

}  // namespace

ResidualStatistics residualStatistics(const std::vector<Eigen::Vector3f>& points, const Pose& pose,
                                      const SurfaceIndex& target, double limit_m) {
    const std::size_t stride = points.size() / kMostPoints + 1;
    std::vector<double> found(points.size() / stride, 2 * limit_m);
    parallelFor(found.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d x = pose * points[stride * i].cast<double>();
            const SurfaceCell* plane = target.over(x, Eigen::Vector3d::UnitZ(), 0);
            if (!plane) continue;
            Eigen::Index largest = 0;
            plane->normal.cwiseAbs().maxCoeff(&largest);
            const double distance = plane->normal.dot(x - plane->mean);
            found[i] = plane->normal[largest] < 0 ? -distance : distance;
        }
    });
    std::erase_if(found, [&](double distance) { return std::abs(distance) > limit_m; });
    ResidualStatistics result;
    result.histogram.counts.assign(2 * kHalfBins + 1, 0);
    if (found.empty()) return result;
    double squares = 0;
    std::vector<double> sizes;
    for (const double distance : found) {
        squares += distance * distance;
        sizes.push_back(std::abs(distance));
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    result.rmse_m = std::sqrt(squares / static_cast<double>(found.size()));
    result.sigma_m = kSigmasPerMad * *middle;
    result.histogram.width_m = roundWidth(result.sigma_m / 3);
    for (const double distance : found) {
        const auto bin = std::lround(distance / result.histogram.width_m);
        if (std::abs(bin) > kHalfBins)
            ++result.histogram.outside;
        else
            ++result.histogram.counts[static_cast<std::size_t>(bin + kHalfBins)];
    }
    return result;
}

}  // namespace vestige
