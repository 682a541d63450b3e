#include "core/registration/global/SearchVoxel.h"

#include <algorithm>

#include "core/registration/Grain.h"

namespace vestige {
namespace {

constexpr double kVoxelsPerRadius = 40;
constexpr double kSpacings = 1.5;
constexpr double kThicknesses = 3;

}  // namespace

double searchVoxel(const PointCloud& target, const PointCloud& source, double scale, double sourceRadius_m) {
    const double wanted = sourceRadius_m / kVoxelsPerRadius;
    double voxel = wanted;
    const Grain there = grainOf(target, 1, 4 * wanted);
    const Grain here = grainOf(source, scale, 4 * wanted);
    voxel = std::max({voxel, kSpacings * there.spacing_m, kThicknesses * there.thickness_m});
    return std::min(std::max({voxel, kSpacings * here.spacing_m, kThicknesses * here.thickness_m}),
                    4 * wanted);
}

bool plausibleExtent(double source_m, double target_m) {
    constexpr double kMostTimes = 20;
    constexpr double kLeastShare = 1.0 / 200;
    return source_m < kMostTimes * target_m && source_m > kLeastShare * target_m;
}

}  // namespace vestige
