#include "core/simulation/NightLight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace vestige {

double nightLight(const std::vector<Eigen::Vector3d>& lamps, const Eigen::Vector3d& place,
                  const Eigen::Vector3d& normal) {
    double light = 0.02;
    for (const Eigen::Vector3d& lamp : lamps) {
        const Eigen::Vector3d towards = lamp - place;
        const double squared = towards.squaredNorm();
        light += 100 / squared * std::abs(normal.dot(towards)) / std::sqrt(squared);
    }
    return light;
}

Color nightColor(const Optics& optics, double light) {
    Color color{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // Sodium-like lamps: red keeps its value, blue loses most of it.
        const double tint = channel == 0 ? 1.0 : channel == 1 ? 0.85 : 0.6;
        const double encoded = std::pow(std::min(1.0, 0.5 * tint * light * optics.color[channel]), 1 / 2.2);
        color[channel] = static_cast<std::uint16_t>(257 * std::lround(255 * encoded));
    }
    return color;
}

}  // namespace vestige
