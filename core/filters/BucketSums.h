#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/filters/CellRanks.h"
#include "core/filters/PlacedPoints.h"

namespace vestige {

/// Of the points of one cell: sums of their places within it, their number, and the low bits of its key.
struct alignas(32) CellSum {
    std::array<std::uint64_t, 3> sums;
    std::uint32_t count;
    std::uint32_t key;

    /// The mean, rounded to the step of a place.
    PlacedPoint mean() const {
        const double share = 1 / static_cast<double>(count);
        PlacedPoint mean{};
#pragma GCC unroll 3
        for (std::size_t axis = 0; axis < 3; ++axis)
            mean.within[axis] = static_cast<std::uint32_t>(static_cast<std::int64_t>(
                static_cast<double>(static_cast<std::int64_t>(sums[axis])) * share + 0.5));
        mean.key = key;
        return mean;
    }
};

/// Sums points by cell, one bucket after another. Ends with a take...(), which forgets the bucket.
class BucketSums {
  public:
    explicit BucketSums(unsigned keyBits) : ranks_(keyBits) {}

    void mark(std::span<const PlacedPoint> points) {
        for (const PlacedPoint& point : points) ranks_.mark(point.key);
    }
    /// The number of cells marked; their sums begin at nothing.
    std::uint32_t begin() {
        const std::uint32_t cells = ranks_.count();
        sums_.assign(cells, CellSum{});
        return cells;
    }
    void add(std::span<const PlacedPoint> points) {
        const __m256i one = _mm256_set_epi64x(1, 0, 0, 0);
        for (const PlacedPoint& point : points) {
            const __m256i place =
                _mm256_cvtepu32_epi64(_mm_load_si128(reinterpret_cast<const __m128i*>(&point)));
            // Where the key was, one is counted.
            const __m256i term = _mm256_blend_epi32(place, one, 0b11000000);
            auto* const sum = reinterpret_cast<__m256i*>(&sums_[ranks_.rank(point.key)]);
            _mm256_store_si256(sum, _mm256_add_epi64(_mm256_load_si256(sum), term));
        }
    }

    /// The points' indices cell by cell go into `order`; each cell's first place there, plus `base`, is
    /// appended to `begins`.
    void sortByCell(std::span<const PlacedPoint> points, std::span<const std::uint32_t> indices,
                    std::uint32_t base, std::span<std::uint32_t> order, std::vector<std::uint32_t>& begins);
    /// Appends to `chosen`, cell by cell, the index of the point nearest to the cell's mean, of equals the
    /// first.
    void chooseNearest(std::span<const PlacedPoint> points, std::span<const std::uint32_t> indices,
                       std::vector<std::uint32_t>& chosen);

    /// In ascending order of the key.
    template <class Use>
    void take(const Use& use) {
        std::size_t rank = 0;
        ranks_.takeKeys([&](std::uint32_t key) {
            sums_[rank].key = key;
            use(sums_[rank++]);
        });
    }

  private:
    struct Nearest {
        std::int64_t squared;
        std::uint32_t index;
    };

    CellRanks ranks_;
    std::vector<CellSum> sums_;
    std::vector<PlacedPoint> means_;
    std::vector<Nearest> nearest_;
    std::vector<std::uint32_t> next_;
};

}  // namespace vestige
