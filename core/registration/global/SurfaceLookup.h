#pragma once

#include <cstdint>
#include <vector>

#include "core/registration/global/Surfels.h"
#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {

/// The target's surface for one look per query: every cell within reach of a surfel holds the surfel nearest
/// to its middle. The surfels must outlive it.
class SurfaceLookup {
  public:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// Cells of `cell_m`; a surfel reaches the cells whose middle is within 1.5 `cell_m`.
    SurfaceLookup(const Surfels& surfels, double cell_m);

    /// A surfel within about 2 `cell_m`, and not much further than the nearest; kNone where there is none.
    std::uint32_t near(const Eigen::Vector3f& x) const {
        const std::uint64_t key = grid_.key(x.x(), x.y(), x.z());
        if (key == VoxelGrid::kNoKey) return kNone;
        std::size_t slot = VoxelGrid::hash(key) & mask_;
        while (table_[slot].key != key) {
            if (table_[slot].key == VoxelGrid::kNoKey) return kNone;
            slot = (slot + 1) & mask_;
        }
        return table_[slot].surfel;
    }
    const Surfels& surfels() const { return surfels_; }
    double cell_m() const { return grid_.size(); }

  private:
    struct Entry {
        std::uint64_t key = VoxelGrid::kNoKey;
        std::uint32_t surfel = kNone;
        float squaredDistance = 0;
    };
    void put(std::uint64_t key, std::uint32_t surfel, float squaredDistance);
    void grow();

    const Surfels& surfels_;
    VoxelGrid grid_;
    std::vector<Entry> table_;
    std::size_t mask_ = 0;
    std::size_t used_ = 0;
};

}  // namespace vestige
