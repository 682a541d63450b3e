#include "core/filters/VoxelMeans.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Parallel.h"
#include "core/filters/CellBuckets.h"
#include "core/filters/CellRanks.h"
#include "core/filters/LoopProgress.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

constexpr std::size_t kBucketGrain = 8;

/// Sums of places within a cell, and their number.
struct alignas(32) CellSum {
    std::array<std::uint64_t, 4> sums;
};

/// Works on one bucket after another. The bucket's points give way to one PlacedPoint per cell, its mean.
class BucketSums {
  public:
    explicit BucketSums(unsigned keyBits) : ranks_(keyBits) {}

    /// The number of cells.
    std::uint32_t sum(std::span<const PlacedPoint> points) {
        for (const PlacedPoint& point : points) ranks_.mark(point.key);
        const std::uint32_t cells = ranks_.count();
        sums_.assign(cells, CellSum{});
        const __m256i count = _mm256_set_epi64x(1, 0, 0, 0);
        for (const PlacedPoint& point : points) {
            auto* const sum = reinterpret_cast<__m256i*>(&sums_[ranks_.rank(point.key)]);
            const __m256i place =
                _mm256_cvtepu32_epi64(_mm_load_si128(reinterpret_cast<const __m128i*>(&point)));
            // The key's lane counts.
            const __m256i term = _mm256_blend_epi32(place, count, 0b11000000);
            _mm256_store_si256(sum, _mm256_add_epi64(_mm256_load_si256(sum), term));
        }
        return cells;
    }

    /// Sorts the points' indices by cell; begins[r] of cell r, counted from `base`, go into `begins`.
    void sortByCell(std::span<const PlacedPoint> points, std::span<std::uint32_t> indices, std::uint32_t base,
                    std::vector<std::uint32_t>& begins) {
        next_.resize(sums_.size());
        std::uint32_t at = 0;
        for (std::size_t cell = 0; cell < sums_.size(); ++cell) {
            begins.push_back(base + at);
            next_[cell] = at;
            at += static_cast<std::uint32_t>(sums_[cell].sums[3]);
        }
        sorted_.resize(indices.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            sorted_[next_[ranks_.rank(points[i].key)]++] = indices[i];
        std::copy(sorted_.begin(), sorted_.end(), indices.begin());
    }

    /// Puts the index of the point nearest to its cell's mean before the others', cell by cell.
    void nearestFirst(std::span<const PlacedPoint> points, std::span<std::uint32_t> indices) {
        means_.clear();
        for (const CellSum& sum : sums_) means_.push_back(mean(sum, 0));
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
        for (std::size_t cell = 0; cell < nearest_.size(); ++cell) indices[cell] = nearest_[cell].index;
    }

    /// Writes the means over the points and forgets the bucket.
    void takeMeans(std::span<PlacedPoint> into) {
        std::size_t cell = 0;
        ranks_.takeKeys([&](std::uint32_t key) {
            into[cell] = mean(sums_[cell], key);
            ++cell;
        });
    }

  private:
    static PlacedPoint mean(const CellSum& sum, std::uint32_t key) {
        const double share = 1 / static_cast<double>(sum.sums[3]);
        PlacedPoint mean{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            mean.within[axis] = static_cast<std::uint32_t>(static_cast<std::int64_t>(
                static_cast<double>(static_cast<std::int64_t>(sum.sums[axis])) * share + 0.5));
        mean.key = key;
        return mean;
    }

    struct Nearest {
        std::int64_t squared;
        std::uint32_t index;
    };

    CellRanks ranks_;
    std::vector<CellSum> sums_;
    std::vector<PlacedPoint> means_;
    std::vector<Nearest> nearest_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> sorted_;
};

bool mayNeedResiduals(const PointSpan& points) {
    const Eigen::Vector3d reach = (points.bounds.min - points.origin)
                                      .cwiseAbs()
                                      .cwiseMax((points.bounds.max - points.origin).cwiseAbs());
    return reach.maxCoeff() > static_cast<double>(PointCloudBuilder::kExactRange);
}

}  // namespace

VoxelMeans voxelMeans(const CellLayout& layout, const PointSpan& points, VoxelWants wants,
                      const JobControl& control) {
    VoxelMeans means;
    if (points.offsets.empty()) return means;
    const PointPlacer placer(layout, points);
    CellBuckets buckets(layout, placer, points.offsets.size(), wants != VoxelWants::means, control);
    const std::size_t many = buckets.bucketCount();
    LoopProgress progress(control, many, "voxels");
    std::vector<std::uint32_t> firstCell(many + 1, 0);
    std::vector<std::vector<std::uint32_t>> begins(wants == VoxelWants::members ? many : 0);
    parallelFor(many, kBucketGrain, [&](std::size_t first, std::size_t last) {
        BucketSums sums(buckets.keyBits());
        for (std::size_t bucket = first; bucket < last; ++bucket) {
            const std::span<PlacedPoint> inside = buckets.points(bucket);
            if (inside.empty()) continue;
            firstCell[bucket + 1] = sums.sum(inside);
            if (wants == VoxelWants::members)
                sums.sortByCell(inside, buckets.indices(bucket), buckets.begin(bucket), begins[bucket]);
            if (wants == VoxelWants::nearest) sums.nearestFirst(inside, buckets.indices(bucket));
            sums.takeMeans(inside);
        }
        progress.done(last - first);
    });
    for (std::size_t bucket = 0; bucket < many; ++bucket) firstCell[bucket + 1] += firstCell[bucket];
    const std::uint32_t cells = firstCell.back();
    const bool far = mayNeedResiduals(points);
    if (wants == VoxelWants::nearest) {
        means.nearest.resize(cells);
    } else {
        means.offsets.resize(cells);
        if (far) means.residuals.resize(cells);
    }
    if (wants == VoxelWants::members) {
        means.members.order.assign(buckets.indices().begin(), buckets.indices().end());
        means.members.begins.resize(cells + 1);
        means.members.begins[cells] = static_cast<std::uint32_t>(points.offsets.size());
    }
    parallelFor(many, kBucketGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t bucket = first; bucket < last; ++bucket) {
            const std::uint32_t from = firstCell[bucket];
            const std::size_t here = firstCell[bucket + 1] - from;
            if (wants == VoxelWants::nearest) {
                std::copy_n(buckets.indices(bucket).begin(), here, means.nearest.begin() + from);
                continue;
            }
            if (wants == VoxelWants::members)
                std::copy(begins[bucket].begin(), begins[bucket].end(), means.members.begins.begin() + from);
            const std::span<const PlacedPoint> placed = buckets.points(bucket).first(here);
            for (std::size_t i = 0; i < here; ++i) {
                const auto steps =
                    layout.steps(static_cast<std::uint64_t>(bucket) << buckets.keyBits() | placed[i].key);
                for (int axis = 0; axis < 3; ++axis) {
                    const double offset =
                        placer.offset(axis, steps[axis],
                                      static_cast<double>(placed[i].within[static_cast<std::size_t>(axis)]));
                    const auto single = static_cast<float>(offset);
                    means.offsets[from + i][axis] = single;
                    if (far)
                        means.residuals[from + i][axis] =
                            static_cast<float>(offset - static_cast<double>(single));
                }
            }
        }
    });
    return means;
}

}  // namespace vestige
