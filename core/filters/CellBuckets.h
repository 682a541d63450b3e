#pragma once

#include <cstdint>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/ScratchArray.h"
#include "core/filters/PlacedPoints.h"

namespace vestige {

/// Points dealt into buckets, each a range of the cells' keys: bucket b holds the keys from b << keyBits()
/// on. Every chunk of the cloud is dealt by itself, within the cache; a bucket is a piece of each chunk. A
/// bucket's cells are few enough to be counted in a bitmap.
class CellBuckets {
  public:
    /// Whether the cells of this layout are few enough for buckets.
    static bool covers(const CellLayout& layout) {
        return layout.keyBits() <= kMostBucketBits + kMostKeyBits;
    }

    /// covers(layout). Throws ErrorException when the job is cancelled.
    CellBuckets(const CellLayout& layout, const PointPlacer& placer, std::size_t points, bool withIndices,
                const JobControl& control);

    std::size_t bucketCount() const { return begins_.size() - 1; }
    unsigned keyBits() const { return keyBits_; }
    /// Of a bucket's points among those of all buckets, bucket after bucket.
    std::uint32_t begin(std::size_t bucket) const { return begins_[bucket]; }
    std::uint32_t size(std::size_t bucket) const { return begins_[bucket + 1] - begins_[bucket]; }

    /// use(points) for a bucket's points piece by piece, in ascending order of their index.
    template <class Use>
    void eachPiece(std::size_t bucket, const Use& use) const {
        for (std::size_t chunk = 0; chunk < chunks_; ++chunk) {
            const auto [from, to] = piece(chunk, bucket);
            if (from < to) use(points_.span().subspan(from, to - from));
        }
    }
    /// A bucket's points and their indices, which were asked for, in ascending order of the index.
    void gather(std::size_t bucket, std::vector<PlacedPoint>& points,
                std::vector<std::uint32_t>& indices) const;

  private:
    static constexpr unsigned kMostBucketBits = 14;
    static constexpr unsigned kMostKeyBits = 24;
    /// Points; an index within a chunk has 16 bits.
    static constexpr std::size_t kChunk = 65536;

    struct Range {
        std::size_t from;
        std::size_t to;
    };
    Range piece(std::size_t chunk, std::size_t bucket) const {
        const std::uint32_t* const ends = ends_.data() + chunk * bucketCount();
        return {bucket == 0 ? chunk * kChunk : ends[bucket - 1], ends[bucket]};
    }

    void dealChunk(const PointPlacer& placer, std::size_t chunk, std::size_t begin, std::size_t end,
                   bool withIndices);

    unsigned keyBits_ = 0;
    std::size_t chunks_ = 0;
    std::vector<std::uint32_t> begins_;
    ScratchArray<std::uint32_t> ends_;  ///< in points_, of each chunk's buckets
    ScratchArray<PlacedPoint> points_;
    ScratchArray<std::uint16_t> indices_;  ///< within the chunk
};

}  // namespace vestige
