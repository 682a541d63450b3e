#include "core/filters/CellBuckets.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/base/Parallel.h"
#include "core/base/Result.h"

namespace vestige {
namespace {

constexpr std::size_t kPointsPerBucket = 512;
constexpr unsigned kUsualBucketBits = 12;
constexpr std::size_t kBucketGrain = 64;

}  // namespace

CellBuckets::CellBuckets(const CellLayout& layout, const PointPlacer& placer, std::size_t points,
                         bool withIndices, const JobControl& control)
    : chunks_((points + kChunk - 1) / kChunk), points_(points), indices_(withIndices ? points : 0) {
    unsigned bucketBits =
        std::min({kUsualBucketBits, static_cast<unsigned>(std::bit_width(points / kPointsPerBucket)),
                  layout.keyBits()});
    if (layout.keyBits() > bucketBits + kMostKeyBits) bucketBits = layout.keyBits() - kMostKeyBits;
    keyBits_ = layout.keyBits() - bucketBits;
    const std::uint64_t pastLast = layout.key(static_cast<std::uint64_t>(layout.counts()[0]), 0, 0);
    const std::size_t buckets = ((pastLast - 1) >> keyBits_) + 1;
    begins_.assign(buckets + 1, 0);
    ends_ = ScratchArray<std::uint32_t>(chunks_ * buckets);
    parallelChunks(points, kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        if (control.cancelled()) throw ErrorException{cancelledError()};
        dealChunk(placer, chunk, begin, end, withIndices);
    });
    parallelFor(buckets, kBucketGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t chunk = 0; chunk < chunks_; ++chunk)
            for (std::size_t bucket = first; bucket < last; ++bucket) {
                const auto [from, to] = piece(chunk, bucket);
                begins_[bucket + 1] += static_cast<std::uint32_t>(to - from);
            }
    });
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) begins_[bucket + 1] += begins_[bucket];
}

void CellBuckets::dealChunk(const PointPlacer& placer, std::size_t chunk, std::size_t begin, std::size_t end,
                            bool withIndices) {
    const std::span<std::uint32_t> places = ends_.span().subspan(chunk * bucketCount(), bucketCount());
    std::fill(places.begin(), places.end(), 0);
    placer.each(
        begin, end, keyBits_,
        [&, counts = places.data()](std::size_t, std::uint64_t bucket, __m128i) { ++counts[bucket]; });
    auto place = static_cast<std::uint32_t>(begin);
    for (std::uint32_t& at : places) place += std::exchange(at, place);
    placer.each(begin, end, keyBits_,
                [next = places.data(), points = points_.data(), indices = indices_.data(), begin,
                 withIndices](std::size_t i, std::uint64_t bucket, __m128i placed) {
                    const std::uint32_t to = next[bucket]++;
                    _mm_store_si128(reinterpret_cast<__m128i*>(points + to), placed);
                    if (withIndices) indices[to] = static_cast<std::uint16_t>(i - begin);
                });
}

void CellBuckets::gather(std::size_t bucket, std::vector<PlacedPoint>& points,
                         std::vector<std::uint32_t>& indices) const {
    points.clear();
    indices.clear();
    for (std::size_t chunk = 0; chunk < chunks_; ++chunk) {
        const auto [from, to] = piece(chunk, bucket);
        points.insert(points.end(), points_.data() + from, points_.data() + to);
        for (std::size_t i = from; i < to; ++i)
            indices.push_back(static_cast<std::uint32_t>(chunk * kChunk) + indices_[i]);
    }
}

}  // namespace vestige
