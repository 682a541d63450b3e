#pragma once

#include <immintrin.h>

#include <bit>

#include "core/geometry/NeighbourIndex.h"

namespace vestige {

/// The squared distances of eight points of a leaf, from place `at` on.
inline __m256 leafDistances(const NeighbourIndex::Leaf& leaf, std::size_t at, __m256 x, __m256 y, __m256 z) {
    const __m256 dx = _mm256_sub_ps(_mm256_load_ps(leaf.axes[0].data() + at), x);
    const __m256 dy = _mm256_sub_ps(_mm256_load_ps(leaf.axes[1].data() + at), y);
    const __m256 dz = _mm256_sub_ps(_mm256_load_ps(leaf.axes[2].data() + at), z);
    const __m256 level = _mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy));
    return _mm256_add_ps(level, _mm256_mul_ps(dz, dz));
}

/// Calls use(place in the leaf, squared distance) for each point of the leaf at most `limit` away as the
/// scan of its eight begins.
template <class Use>
void scanLeaf(const NeighbourIndex::Leaf& leaf, const Eigen::Vector3f& centre, const float& limit,
              const Use& use) {
    const __m256 x = _mm256_set1_ps(centre.x());
    const __m256 y = _mm256_set1_ps(centre.y());
    const __m256 z = _mm256_set1_ps(centre.z());
    for (std::size_t at = 0; at < NeighbourIndex::kLeaf; at += 8) {
        const __m256 squared = leafDistances(leaf, at, x, y, z);
        auto within = static_cast<unsigned>(
            _mm256_movemask_ps(_mm256_cmp_ps(squared, _mm256_set1_ps(limit), _CMP_LE_OQ)));
        if (within == 0) continue;
        alignas(32) std::array<float, 8> distances;
        _mm256_store_ps(distances.data(), squared);
        for (; within != 0; within &= within - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(within));
            use(at + lane, distances[lane]);
        }
    }
}

}  // namespace vestige
