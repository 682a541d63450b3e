#include "core/registration/global/SurfaceLookup.h"

#include <algorithm>
#include <bit>

namespace vestige {

SurfaceLookup::SurfaceLookup(const Surfels& surfels, double cell_m) : surfels_(surfels), grid_(cell_m) {
    table_.resize(std::bit_ceil(std::max<std::size_t>(64, surfels.size())));
    mask_ = table_.size() - 1;
    const auto reach = static_cast<float>(2.25 * cell_m * cell_m);
    for (std::uint32_t i = 0; i < surfels.size(); ++i) {
        const Eigen::Vector3f& point = surfels.points[i];
        const std::uint64_t middle = grid_.key(point.x(), point.y(), point.z());
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const std::uint64_t key = VoxelGrid::neighbour(middle, dx, dy, dz);
                    if (key == VoxelGrid::kNoKey) continue;
                    const Eigen::Vector3f centre(static_cast<float>(grid_.centreX(key)),
                                                 static_cast<float>(grid_.centreY(key)),
                                                 static_cast<float>(grid_.centreZ(key)));
                    const float square = (centre - point).squaredNorm();
                    if (square <= reach) put(key, i, square);
                }
    }
}

void SurfaceLookup::put(std::uint64_t key, std::uint32_t surfel, float squaredDistance) {
    std::size_t slot = VoxelGrid::hash(key) & mask_;
    while (table_[slot].key != key && table_[slot].key != VoxelGrid::kNoKey) slot = (slot + 1) & mask_;
    Entry& entry = table_[slot];
    if (entry.key == key) {
        if (squaredDistance < entry.squaredDistance) entry = {key, surfel, squaredDistance};
        return;
    }
    entry = {key, surfel, squaredDistance};
    if (++used_ * 2 > table_.size()) grow();
}

void SurfaceLookup::grow() {
    std::vector<Entry> old(2 * table_.size());
    old.swap(table_);
    mask_ = table_.size() - 1;
    for (const Entry& entry : old) {
        if (entry.key == VoxelGrid::kNoKey) continue;
        std::size_t slot = VoxelGrid::hash(entry.key) & mask_;
        while (table_[slot].key != VoxelGrid::kNoKey) slot = (slot + 1) & mask_;
        table_[slot] = entry;
    }
}

}  // namespace vestige
