#include "core/registration/ndt/VoxelSchedule.h"

#include <algorithm>

namespace vestige {
namespace {

bool holdsShare(const FlatnessCount& count, std::size_t targetPoints, double share) {
    return static_cast<double>(count.points) >= share * static_cast<double>(targetPoints);
}

}  // namespace

std::vector<double> voxelSchedule(double start, double finest, double factor) {
    std::vector<double> sizes;
    // The margin keeps a size that equals `finest` but for rounding from appearing twice.
    for (double size = start; size > finest * (1 + 1e-9); size *= factor) sizes.push_back(size);
    sizes.push_back(finest);
    return sizes;
}

bool pastLeastShare(const std::vector<FlatnessCount>& counts, std::size_t targetPoints, double leastShare) {
    if (counts.empty() || holdsShare(counts.back(), targetPoints, leastShare)) return false;
    return std::any_of(counts.begin(), counts.end(), [&](const FlatnessCount& count) {
        return holdsShare(count, targetPoints, leastShare);
    });
}

std::size_t finestByFlatness(const std::vector<FlatnessCount>& counts, std::size_t targetPoints,
                             double ceiling, double leastShare) {
    double largest = -1;
    std::size_t smallest = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!holdsShare(counts[i], targetPoints, leastShare)) continue;
        smallest = i;
        if (counts[i].voxel_m <= ceiling) largest = std::max(largest, counts[i].ratio());
    }
    if (largest < 0) return smallest;
    std::size_t chosen = smallest;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (holdsShare(counts[i], targetPoints, leastShare) && counts[i].voxel_m <= ceiling &&
            counts[i].ratio() >= largest - 0.01)
            chosen = i;
    return chosen;
}

}  // namespace vestige
