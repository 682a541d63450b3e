#include "ui/view/PointBlocks.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/Parallel.h"
#include "ui/view/SampledRange.h"

namespace vestige {
namespace {

constexpr std::uint32_t kBlockBits = 16;
constexpr std::uint32_t kBlockSize = 1U << kBlockBits;
constexpr std::size_t kGrain = 16384;

std::uint64_t spreadBits(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

std::vector<std::uint32_t> mortonOrder(const PointCloud& cloud) {
    const auto& offsets = cloud.offsets();
    Eigen::Vector3f low = offsets[0];
    Eigen::Vector3f high = offsets[0];
    for (const auto& offset : offsets) {
        low = low.cwiseMin(offset);
        high = high.cwiseMax(offset);
    }
    const double side = std::max(1e-6, static_cast<double>((high - low).maxCoeff()));
    const double cells = (1 << 21) - 1;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(offsets.size());
    parallelFor(offsets.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d cell = (offsets[i] - low).cast<double>() * (cells / side);
            keyed[i] = {spreadBits(static_cast<std::uint64_t>(cell.x())) << 2 |
                            spreadBits(static_cast<std::uint64_t>(cell.y())) << 1 |
                            spreadBits(static_cast<std::uint64_t>(cell.z())),
                        static_cast<std::uint32_t>(i)};
        }
    });
    std::sort(keyed.begin(), keyed.end());
    std::vector<std::uint32_t> order(keyed.size());
    std::transform(keyed.begin(), keyed.end(), order.begin(), [](const auto& pair) { return pair.second; });
    return order;
}

std::uint32_t reversedBits(std::uint32_t x) {
    std::uint32_t reversed = 0;
    for (std::uint32_t bit = 0; bit < kBlockBits; ++bit, x >>= 1) reversed = reversed << 1 | (x & 1);
    return reversed;
}

/// The ranks below kBlockSize with their bits reversed: neighbours on the curve come far apart.
const std::vector<std::uint32_t>& scatteredRanks() {
    static const std::vector<std::uint32_t> ranks = [] {
        std::vector<std::uint32_t> all(kBlockSize);
        for (std::uint32_t i = 0; i < kBlockSize; ++i) all[i] = reversedBits(i);
        return all;
    }();
    return ranks;
}

/// The median step along the Morton curve, divided by what that exceeds the distance of the nearest neighbour
/// by on an even surface.
double typicalSpacing(const PointCloud& cloud, std::span<const std::uint32_t> morton, double scale) {
    SampledRange steps;
    steps.sample(cloud.size() - 1, [&](std::size_t i) {
        return (cloud.offsets()[morton[i + 1]] - cloud.offsets()[morton[i]]).norm();
    });
    return steps.empty() ? 0 : scale * steps.quantile(0.5) / 1.2;
}

}  // namespace

PointBlocks makePointBlocks(const PointCloud& cloud, const Similarity& worldFromLayer,
                            const Eigen::Vector3d& displayOrigin, std::span<const std::uint32_t> morton) {
    PointBlocks made;
    if (cloud.empty()) return made;
    std::vector<std::uint32_t> own;
    if (morton.size() != cloud.size()) {
        own = mortonOrder(cloud);
        morton = own;
    }
    made.order.resize(cloud.size());
    made.positions.resize(cloud.size());
    made.blocks.resize((cloud.size() + kBlockSize - 1) / kBlockSize);
    made.spacing_m = typicalSpacing(cloud, morton, worldFromLayer.scale);
    const std::vector<std::uint32_t>& ranks = scatteredRanks();
    parallelChunks(cloud.size(), kBlockSize, [&](std::size_t block, std::size_t begin, std::size_t end) {
        std::size_t next = begin;
        for (const std::uint32_t rank : ranks)
            if (begin + rank < end) made.order[next++] = morton[begin + rank];
        PointBlock& box = made.blocks[block];
        box.begin = static_cast<std::uint32_t>(begin);
        box.end = static_cast<std::uint32_t>(end);
        for (std::size_t i = begin; i < end; ++i) {
            made.positions[i] = (worldFromLayer * cloud.point(made.order[i]) - displayOrigin).cast<float>();
            box.min = i == begin ? made.positions[i] : Eigen::Vector3f(box.min.cwiseMin(made.positions[i]));
            box.max = i == begin ? made.positions[i] : Eigen::Vector3f(box.max.cwiseMax(made.positions[i]));
        }
    });
    return made;
}

}  // namespace vestige
