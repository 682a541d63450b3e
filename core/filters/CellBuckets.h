#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/ScratchArray.h"
#include "core/filters/PlacedPoints.h"

namespace vestige {

/// Points dealt into buckets, each a range of the cells' keys: bucket b holds the keys from b << keyBits()
/// on. Points keep their order within a bucket. A bucket's cells are few enough to be counted in a bitmap.
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
    std::uint32_t begin(std::size_t bucket) const { return begins_[bucket]; }
    std::uint32_t size(std::size_t bucket) const { return begins_[bucket + 1] - begins_[bucket]; }
    /// Those who are done with a bucket's points may keep things of their own in their place.
    std::span<PlacedPoint> points(std::size_t bucket) {
        return points_.span().subspan(begin(bucket), size(bucket));
    }
    /// Their indices; empty when not asked for.
    std::span<std::uint32_t> indices(std::size_t bucket) {
        return indices_.size() == 0 ? std::span<std::uint32_t>()
                                    : indices_.span().subspan(begin(bucket), size(bucket));
    }
    std::span<const std::uint32_t> indices() const { return indices_.span(); }

  private:
    static constexpr unsigned kMostBucketBits = 14;
    static constexpr unsigned kMostKeyBits = 24;

    unsigned keyBits_ = 0;
    std::vector<std::uint32_t> begins_;
    ScratchArray<PlacedPoint> points_;
    ScratchArray<std::uint32_t> indices_;
};

}  // namespace vestige
