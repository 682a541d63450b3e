#include "core/filters/BucketSums.h"

namespace vestige {

void BucketSums::sortByCell(std::span<const PlacedPoint> points, std::span<const std::uint32_t> indices,
                            std::uint32_t base, std::span<std::uint32_t> order,
                            std::vector<std::uint32_t>& begins) {
    next_.resize(sums_.size());
    std::uint32_t at = 0;
    for (std::size_t cell = 0; cell < sums_.size(); ++cell) {
        begins.push_back(base + at);
        next_[cell] = at;
        at += sums_[cell].count;
    }
    for (std::size_t i = 0; i < points.size(); ++i) order[next_[ranks_.rank(points[i].key)]++] = indices[i];
}

void BucketSums::chooseNearest(std::span<const PlacedPoint> points, std::span<const std::uint32_t> indices,
                               std::vector<std::uint32_t>& chosen) {
    means_.clear();
    for (const CellSum& sum : sums_) means_.push_back(sum.mean());
    nearest_.assign(sums_.size(), {std::numeric_limits<std::int64_t>::max(), 0});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t cell = ranks_.rank(points[i].key);
        std::int64_t squared = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t apart = static_cast<std::int64_t>(points[i].within[axis]) -
                                       static_cast<std::int64_t>(means_[cell].within[axis]);
            squared += apart * apart;
        }
        // Indices ascend, so the first of equals stays.
        if (squared < nearest_[cell].squared) nearest_[cell] = {squared, indices[i]};
    }
    for (const Nearest& nearest : nearest_) chosen.push_back(nearest.index);
}

}  // namespace vestige
