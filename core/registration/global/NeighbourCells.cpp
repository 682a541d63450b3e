#include "core/registration/global/NeighbourCells.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

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
        std::array<std::vector<float>, 3> along;
        std::vector<Neighbour> found;
        for (std::size_t cell = begin; cell < end; ++cell) {
            gather(cell, near);
            const std::size_t padded = (near.size() + 7) / 8 * 8;
            for (int axis = 0; axis < 3; ++axis) {
                along[axis].assign(padded, std::numeric_limits<float>::infinity());
                for (std::size_t i = 0; i < near.size(); ++i) along[axis][i] = points_[near[i]][axis];
            }
            for (std::uint32_t own = cells_[cell].begin; own < cells_[cell].end; ++own) {
                const std::uint32_t point = order_[own];
                const Eigen::Vector3f p = points_[point];
                found.clear();
                for (std::size_t at = 0; at < padded; at += 8) {
                    const __m256 dx =
                        _mm256_sub_ps(_mm256_loadu_ps(along[0].data() + at), _mm256_set1_ps(p.x()));
                    const __m256 dy =
                        _mm256_sub_ps(_mm256_loadu_ps(along[1].data() + at), _mm256_set1_ps(p.y()));
                    const __m256 dz =
                        _mm256_sub_ps(_mm256_loadu_ps(along[2].data() + at), _mm256_set1_ps(p.z()));
                    const __m256 square =
                        _mm256_fmadd_ps(dz, dz, _mm256_fmadd_ps(dy, dy, _mm256_mul_ps(dx, dx)));
                    auto mask = static_cast<unsigned>(
                        _mm256_movemask_ps(_mm256_cmp_ps(square, _mm256_set1_ps(limit), _CMP_LE_OQ)));
                    if (mask == 0) continue;
                    alignas(32) std::array<float, 8> squares;
                    _mm256_store_ps(squares.data(), square);
                    for (; mask != 0; mask &= mask - 1) {
                        const auto k = static_cast<std::size_t>(std::countr_zero(mask));
                        if (near[at + k] != point) found.push_back({near[at + k], squares[k]});
                    }
                }
                use(point, found);
            }
        }
    });
}

}  // namespace vestige
