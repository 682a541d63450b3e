#include "core/filters/CellBuckets.h"

#include <algorithm>
#include <bit>

#include "core/base/Parallel.h"
#include "core/base/Result.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
constexpr std::size_t kPointsPerBucket = 512;
constexpr unsigned kUsualBucketBits = 12;

/// use(first, lanes, four) for the points [begin, end) of which the last is `last`.
template <class Use>
void eachFour(const PointPlacer& placer, std::size_t begin, std::size_t end, const Use& use) {
    std::size_t i = begin;
    for (; i + 4 <= end; i += 4) use(i, std::size_t{4}, placer.place(i));
    if (i < end) use(i, end - i, placer.placeLast(i));
}

}  // namespace

CellBuckets::CellBuckets(const CellLayout& layout, const PointPlacer& placer, std::size_t points,
                         bool withIndices, const JobControl& control)
    : points_(points), indices_(withIndices ? points : 0) {
    unsigned bucketBits =
        std::min({kUsualBucketBits, static_cast<unsigned>(std::bit_width(points / kPointsPerBucket)),
                  layout.keyBits()});
    if (layout.keyBits() > bucketBits + kMostKeyBits) bucketBits = layout.keyBits() - kMostKeyBits;
    keyBits_ = layout.keyBits() - bucketBits;
    const auto highest = static_cast<std::uint64_t>(layout.counts()[0] - 1);
    const std::size_t buckets = ((layout.key(highest + 1, 0, 0) - 1) >> keyBits_) + 1;
    const __m128i shift = _mm_cvtsi32_si128(static_cast<int>(keyBits_));
    const std::size_t chunks = (points + kGrain - 1) / kGrain;

    std::vector<std::uint32_t> places(chunks * buckets, 0);
    parallelChunks(points, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        if (control.cancelled()) throw ErrorException{cancelledError()};
        std::uint32_t* const counts = places.data() + chunk * buckets;
        eachFour(placer, begin, end, [&](std::size_t, std::size_t lanes, const PointPlacer::Four& four) {
            alignas(32) std::array<std::uint64_t, 4> bucket;
            _mm256_store_si256(reinterpret_cast<__m256i*>(bucket.data()), _mm256_srl_epi64(four.key, shift));
            for (std::size_t lane = 0; lane < lanes; ++lane) ++counts[bucket[lane]];
        });
    });
    begins_.resize(buckets + 1);
    std::uint32_t place = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        begins_[bucket] = place;
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            const std::uint32_t many = places[chunk * buckets + bucket];
            places[chunk * buckets + bucket] = place;
            place += many;
        }
    }
    begins_[buckets] = place;

    const __m256i lowKey = _mm256_set1_epi64x((std::int64_t{1} << keyBits_) - 1);
    parallelChunks(points, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        if (control.cancelled()) throw ErrorException{cancelledError()};
        std::uint32_t* const next = places.data() + chunk * buckets;
        eachFour(
            placer, begin, end, [&](std::size_t first, std::size_t lanes, const PointPlacer::Four& four) {
                alignas(32) std::array<std::uint64_t, 4> bucket;
                _mm256_store_si256(reinterpret_cast<__m256i*>(bucket.data()),
                                   _mm256_srl_epi64(four.key, shift));
                // x y | z key of each point, two points to a register.
                const __m256i xy = _mm256_or_si256(four.within[0], _mm256_slli_epi64(four.within[1], 32));
                const __m256i zKey = _mm256_or_si256(
                    four.within[2], _mm256_slli_epi64(_mm256_and_si256(four.key, lowKey), 32));
                const __m256i even = _mm256_unpacklo_epi64(xy, zKey);
                const __m256i odd = _mm256_unpackhi_epi64(xy, zKey);
                const __m128i placed[]{_mm256_castsi256_si128(even), _mm256_castsi256_si128(odd),
                                       _mm256_extracti128_si256(even, 1), _mm256_extracti128_si256(odd, 1)};
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    const std::uint32_t to = next[bucket[lane]]++;
                    _mm_store_si128(reinterpret_cast<__m128i*>(&points_[to]), placed[lane]);
                    if (withIndices) indices_[to] = static_cast<std::uint32_t>(first + lane);
                }
            });
    });
}

}  // namespace vestige
