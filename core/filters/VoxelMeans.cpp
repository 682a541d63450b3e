#include "core/filters/VoxelMeans.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/filters/BucketSums.h"
#include "core/filters/CellBuckets.h"
#include "core/filters/LoopProgress.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

constexpr std::size_t kBucketGrain = 8;

/// Of one bucket's cells.
struct BucketResult {
    std::vector<PlacedPoint> means;
    std::vector<std::uint32_t> begins;
    std::vector<std::uint32_t> chosen;
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
    const CellBuckets buckets(layout, placer, points.offsets.size(), wants != VoxelWants::means, control);
    const std::size_t many = buckets.bucketCount();
    LoopProgress progress(control, many, "voxels");
    std::vector<BucketResult> results(many);
    if (wants == VoxelWants::members) means.members.order.resize(points.offsets.size());
    parallelFor(many, kBucketGrain, [&](std::size_t first, std::size_t last) {
        BucketSums sums(buckets.keyBits());
        std::vector<PlacedPoint> inside;
        std::vector<std::uint32_t> indices;
        for (std::size_t bucket = first; bucket < last; ++bucket) {
            if (buckets.size(bucket) == 0) continue;
            BucketResult& result = results[bucket];
            buckets.eachPiece(bucket, [&](std::span<const PlacedPoint> piece) { sums.mark(piece); });
            const std::uint32_t cells = sums.begin();
            buckets.eachPiece(bucket, [&](std::span<const PlacedPoint> piece) { sums.add(piece); });
            if (wants != VoxelWants::means) buckets.gather(bucket, inside, indices);
            if (wants == VoxelWants::nearest) sums.chooseNearest(inside, indices, result.chosen);
            if (wants == VoxelWants::members) {
                const std::uint32_t base = buckets.begin(bucket);
                const auto order = std::span(means.members.order).subspan(base, indices.size());
                sums.sortByCell(inside, indices, base, order, result.begins);
            }
            result.means.reserve(cells);
            sums.take([&](const CellSum& cell) { result.means.push_back(cell.mean()); });
        }
        progress.done(last - first);
    });

    std::vector<std::size_t> firstCell(many + 1, 0);
    for (std::size_t bucket = 0; bucket < many; ++bucket)
        firstCell[bucket + 1] = firstCell[bucket] + results[bucket].means.size();
    const std::size_t cells = firstCell.back();
    const bool far = mayNeedResiduals(points);
    if (wants == VoxelWants::nearest) means.nearest.resize(cells);
    if (wants != VoxelWants::nearest) means.offsets.resize(cells);
    if (wants != VoxelWants::nearest && far) means.residuals.resize(cells);
    if (wants == VoxelWants::members) {
        means.members.begins.resize(cells + 1);
        means.members.begins[cells] = static_cast<std::uint32_t>(points.offsets.size());
    }
    parallelFor(many, kBucketGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t bucket = first; bucket < last; ++bucket) {
            const BucketResult& result = results[bucket];
            const auto from = static_cast<std::ptrdiff_t>(firstCell[bucket]);
            std::copy(result.begins.begin(), result.begins.end(), means.members.begins.begin() + from);
            std::copy(result.chosen.begin(), result.chosen.end(), means.nearest.begin() + from);
            if (wants == VoxelWants::nearest) continue;
            std::size_t cell = firstCell[bucket];
            for (const PlacedPoint& mean : result.means) {
                const auto steps =
                    layout.steps(static_cast<std::uint64_t>(bucket) << buckets.keyBits() | mean.key);
#pragma GCC unroll 3
                for (int axis = 0; axis < 3; ++axis) {
                    const double offset = placer.offset(
                        axis, steps[axis], static_cast<double>(mean.within[static_cast<std::size_t>(axis)]));
                    const auto single = static_cast<float>(offset);
                    means.offsets[cell][axis] = single;
                    if (far)
                        means.residuals[cell][axis] =
                            static_cast<float>(offset - static_cast<double>(single));
                }
                ++cell;
            }
        }
    });
    return means;
}

}  // namespace vestige
