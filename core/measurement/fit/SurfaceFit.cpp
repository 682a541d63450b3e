#include "core/measurement/fit/SurfaceFit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/measurement/fit/ExtremeFit.h"

namespace vestige {

std::optional<PlaceFit> surfaceAtSeed(const Neighbourhood& near) {
    const double beside = std::max(1.2 * near.noise_m, 2 * near.spacing_m);
    // Farther before or behind the point that was hit there is something else.
    const double deep = 6 * near.noise_m + 2 * near.spacing_m;
    std::vector<double> heights;
    double squares = 0;
    for (const FitPoint& point : near.points) {
        const double at = near.view.dot(point.position);
        if ((point.position - at * near.view).norm() > beside || std::abs(at) > deep) continue;
        heights.push_back(-at);
        const double blur = near.blur_m(point, near.view);
        squares += blur * blur;
    }
    if (heights.empty()) return std::nullopt;
    const auto n = static_cast<double>(heights.size());
    const double noise = std::max(std::sqrt(squares / n), 0.05 * near.spacing_m);
    const auto end = meanUpperEnd(heights, noise);
    if (!end) return std::nullopt;
    PlaceFit fit;
    fit.place = -end->place * near.view;
    const double aside = near.spacing_m * near.spacing_m / 12;
    const double u2 = end->standardUncertainty * end->standardUncertainty;
    fit.covariance = aside * Eigen::Matrix3d::Identity() + (u2 - aside) * near.view * near.view.transpose();
    fit.rms = noise;
    fit.inliers = end->used;
    return fit;
}

}  // namespace vestige
