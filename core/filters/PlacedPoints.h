#pragma once

#include <immintrin.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "core/filters/CellLayout.h"
#include "core/geometry/BoundingBox.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// The coordinates that a voxel grid needs of a cloud, or of bare offsets.
struct PointSpan {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::span<const Eigen::Vector3f> offsets;
    std::span<const Eigen::Vector3f> residuals;  ///< empty or as long as offsets
    BoundingBox bounds;                          ///< world

    PointSpan() = default;
    explicit PointSpan(const PointCloud& cloud)
        : origin(cloud.origin()),
          offsets(cloud.offsets()),
          residuals(cloud.residuals()),
          bounds(cloud.bounds()) {}
};

/// A point's place within its cell, in 2^-30 of the cell's size along each axis, and the low bits of the
/// cell's key.
struct alignas(16) PlacedPoint {
    std::array<std::uint32_t, 3> within;
    std::uint32_t key;
};

/// Places offsets in the cells of a layout, four at a time: world coordinates in cells as fixed-point
/// numbers, 30 bits behind the point, in the mantissas of doubles. One rounding, to 2^-30 of a cell; sums of
/// such places are exact, whatever their order. Places outside the layout are put at its edge.
class PointPlacer {
  public:
    static constexpr unsigned kFractionBits = 30;

    PointPlacer(const CellLayout& layout, const PointSpan& points);

    /// Four cells' keys and the places within them, as 64-bit numbers.
    struct Four {
        __m256i key;
        __m256i within[3];
    };
    /// Points i ... i + 3.
    [[gnu::always_inline]] Four place(std::size_t i) const {
        FourOffsets offsets = fourOf(points_.offsets, i);
        if (!points_.residuals.empty()) {
            const FourOffsets residuals = fourOf(points_.residuals, i);
#pragma GCC unroll 3
            for (std::size_t axis = 0; axis < 3; ++axis)
                offsets.axes[axis] = _mm256_add_pd(offsets.axes[axis], residuals.axes[axis]);
        }
        return place(offsets);
    }
    /// The last points, fewer than four, from point i on; the lanes beyond repeat the last.
    Four placeLast(std::size_t i) const;

    /// use(index, bucket, PlacedPoint in a register) for the points [begin, end) in their order; a bucket is
    /// a key without its lowest `keyBits`, at most 32, which stay with the point.
    template <class Use>
    void each(std::size_t begin, std::size_t end, unsigned keyBits, const Use& use) const {
        std::size_t i = begin;
        for (; i + 4 <= end; i += 4) deal(place(i), i, 4, keyBits, use);
        if (i < end) deal(placeLast(i), i, end - i, keyBits, use);
    }

    /// Offset from the origin of the place `within` + whole cells `steps`, as PlacedPoint has them.
    double offset(int axis, std::int64_t steps, double within) const {
        return ((static_cast<double>(steps << kFractionBits) + within) - shift_[axis]) * perStep_;
    }

  private:
    template <class Use>
    [[gnu::always_inline]] static void deal(const Four& four, std::size_t first, std::size_t lanes,
                                            unsigned keyBits, const Use& use) {
        const __m256i lowKey = _mm256_set1_epi64x((std::int64_t{1} << keyBits) - 1);
        alignas(32) std::array<std::uint64_t, 4> bucket;
        _mm256_store_si256(reinterpret_cast<__m256i*>(bucket.data()),
                           _mm256_srl_epi64(four.key, _mm_cvtsi32_si128(static_cast<int>(keyBits))));
        // x y | z key of each point, two points to a register.
        const __m256i xy = _mm256_or_si256(four.within[0], _mm256_slli_epi64(four.within[1], 32));
        const __m256i zKey =
            _mm256_or_si256(four.within[2], _mm256_slli_epi64(_mm256_and_si256(four.key, lowKey), 32));
        const __m256i even = _mm256_unpacklo_epi64(xy, zKey);
        const __m256i odd = _mm256_unpackhi_epi64(xy, zKey);
        const __m128i placed[]{_mm256_castsi256_si128(even), _mm256_castsi256_si128(odd),
                               _mm256_extracti128_si256(even, 1), _mm256_extracti128_si256(odd, 1)};
        if (lanes == 4) {
#pragma GCC unroll 4
            for (std::size_t lane = 0; lane < 4; ++lane) use(first + lane, bucket[lane], placed[lane]);
        } else {
            for (std::size_t lane = 0; lane < lanes; ++lane) use(first + lane, bucket[lane], placed[lane]);
        }
    }

    struct FourOffsets {
        __m256d axes[3];
    };

    static FourOffsets fourOf(std::span<const Eigen::Vector3f> points, std::size_t i) {
        // x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3
        const float* const at = points[i].data();
        const __m128 a = _mm_loadu_ps(at);
        const __m128 b = _mm_loadu_ps(at + 4);
        const __m128 c = _mm_loadu_ps(at + 8);
        const __m128 x = _mm_blend_ps(_mm_blend_ps(a, b, 0b0100), c, 0b0010);
        const __m128 y = _mm_blend_ps(_mm_blend_ps(b, a, 0b0010), c, 0b0100);
        const __m128 z = _mm_blend_ps(_mm_blend_ps(c, b, 0b0010), a, 0b0100);
        return {{_mm256_cvtps_pd(_mm_permute_ps(x, 0b01101100)),
                 _mm256_cvtps_pd(_mm_permute_ps(y, 0b10110001)),
                 _mm256_cvtps_pd(_mm_permute_ps(z, 0b11000110))}};
    }

    [[gnu::always_inline]] Four place(const FourOffsets& offsets) const {
        const __m256d scale = _mm256_set1_pd(scale_);
        const __m256i fraction = _mm256_set1_epi64x((std::int64_t{1} << kFractionBits) - 1);
        const __m256i cell = _mm256_set1_epi64x((std::int64_t{1} << 21) - 1);
        Four four;
        __m256i cells[3];
#pragma GCC unroll 3
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int a = static_cast<int>(axis);
            __m256d fixed = _mm256_fmadd_pd(offsets.axes[axis], scale, _mm256_set1_pd(shiftOfFixed_[a]));
            fixed = _mm256_min_pd(fixed, _mm256_set1_pd(most_[a]));
            fixed = _mm256_max_pd(fixed, _mm256_set1_pd(kFixed));
            const __m256i bits = _mm256_castpd_si256(fixed);
            four.within[axis] = _mm256_and_si256(bits, fraction);
            cells[axis] = _mm256_and_si256(_mm256_srli_epi64(bits, static_cast<int>(kFractionBits)), cell);
        }
        four.key = _mm256_or_si256(
            _mm256_or_si256(_mm256_sll_epi64(cells[0], shiftX_), _mm256_sll_epi64(cells[1], shiftY_)),
            cells[2]);
        return four;
    }

    /// Doubles from here to twice as much have their unit in the last bit of the mantissa.
    static constexpr double kFixed = static_cast<double>(std::uint64_t{1} << 52);

    PointSpan points_;
    double scale_ = 0;    ///< steps of 2^-30 cells per unit
    double perStep_ = 0;  ///< and back
    Eigen::Vector3d shift_;
    Eigen::Vector3d shiftOfFixed_;
    Eigen::Vector3d most_;
    __m128i shiftX_;
    __m128i shiftY_;
};

}  // namespace vestige
