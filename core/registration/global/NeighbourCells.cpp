#include "core/registration/global/NeighbourCells.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr std::size_t kCellGrain = 64;

}  // namespace

NeighbourCells::NeighbourCells(std::span<const Eigen::Vector3f> points, float radius)
    : points_(points), radius_(radius), grid_(radius) {
    const auto sorted =
        sortedByKey<std::uint64_t>(points.size(), 63, [&](std::size_t begin, std::span<std::uint64_t> keys) {
            for (std::size_t i = 0; i < keys.size(); ++i) {
                const Eigen::Vector3f& point = points[begin + i];
                keys[i] = grid_.key(point.x(), point.y(), point.z());
            }
        });
    order_.resize(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const auto at = static_cast<std::uint32_t>(i);
        if (cells_.empty() || cells_.back().key != sorted[i].key) cells_.push_back({sorted[i].key, at, at});
        cells_.back().end = at + 1;
        order_[i] = sorted[i].index;
    }
}

void NeighbourCells::gather(std::size_t cell, std::vector<std::uint32_t>& near) const {
    near.clear();
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy) {
            // Neighbours along x have consecutive keys.
            const std::uint64_t first = VoxelGrid::neighbour(cells_[cell].key, -1, dy, dz);
            if (first == VoxelGrid::kNoKey) continue;
            auto at = std::lower_bound(cells_.begin(), cells_.end(), first,
                                       [](const Cell& c, std::uint64_t key) { return c.key < key; });
            for (; at != cells_.end() && at->key <= first + 2; ++at)
                near.insert(near.end(), order_.begin() + at->begin, order_.begin() + at->end);
        }
}

void NeighbourCells::forEach(const Use& use) const {
    const float limit = radius_ * radius_;
    parallelFor(cells_.size(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> near;
        std::vector<float> x, y, z, squares;
        std::vector<Neighbour> found;
        for (std::size_t cell = begin; cell < end; ++cell) {
            gather(cell, near);
            x.resize(near.size());
            y.resize(near.size());
            z.resize(near.size());
            squares.resize(near.size());
            for (std::size_t i = 0; i < near.size(); ++i) {
                x[i] = points_[near[i]].x();
                y[i] = points_[near[i]].y();
                z[i] = points_[near[i]].z();
            }
            for (std::uint32_t own = cells_[cell].begin; own < cells_[cell].end; ++own) {
                const std::uint32_t point = order_[own];
                const Eigen::Vector3f p = points_[point];
                for (std::size_t i = 0; i < near.size(); ++i) {
                    const float dx = x[i] - p.x(), dy = y[i] - p.y(), dz = z[i] - p.z();
                    squares[i] = dx * dx + dy * dy + dz * dz;
                }
                found.clear();
                for (std::size_t i = 0; i < near.size(); ++i)
                    if (squares[i] <= limit && near[i] != point) found.push_back({near[i], squares[i]});
                use(point, found);
            }
        }
    });
}

}  // namespace vestige
