#include "ui/view/PointBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/Parallel.h"
#include "ui/view/SampledRange.h"

namespace vestige {
namespace {

/// A step along the Morton curve exceeds the distance of the nearest neighbour by this on an even surface.
constexpr double kStepPerSpacing = 1.2;
constexpr std::uint32_t kStepsSampled = 64;
/// Points of a picture stand this near, so that one falls onto every pixel whatever their unevenness.
constexpr double kDensest_px = 0.5;
constexpr std::uint32_t kLeastPoints = 64;

std::uint32_t reversedBits(std::uint32_t x) {
    x = (x & 0x5555U) << 1 | (x >> 1 & 0x5555U);
    x = (x & 0x3333U) << 2 | (x >> 2 & 0x3333U);
    x = (x & 0x0f0fU) << 4 | (x >> 4 & 0x0f0fU);
    return (x & 0x00ffU) << 8 | (x >> 8 & 0x00ffU);
}

/// The first step along the Morton curve to another place, of the steps that begin at [begin, end); 0 when
/// the points there all coincide. Points that coincide (a tile that was merged twice) do not tell how far
/// apart places are.
double stepAt(const Octree& octree, std::size_t begin, std::size_t end) {
    const auto& offsets = octree.cloud().offsets();
    for (std::size_t place = begin; place < end; ++place)
        if (const Eigen::Vector3f step = offsets[octree.order()[place + 1]] - offsets[octree.order()[place]];
            !step.isZero(0))
            return step.norm();
    return 0;
}

/// The median step along the Morton curve as a distance of neighbours, in the cloud's unit.
double typicalSpacing(const Octree& octree) {
    SampledRange steps;
    const std::size_t count = octree.cloud().size() - 1;
    steps.sample(count, [&](std::size_t i) {
        const double step = stepAt(octree, i, std::min(count, i + SampledRange::stride(count)));
        return step > 0 ? step : std::numeric_limits<double>::quiet_NaN();
    });
    return steps.empty() ? 0 : steps.quantile(0.5) / kStepPerSpacing;
}

/// The same of the points [begin, end) of the octree's order.
double medianSpacing(const Octree& octree, std::uint32_t begin, std::uint32_t end) {
    if (end - begin < 2) return 0;
    const std::uint32_t count = std::min(kStepsSampled, end - begin - 1);
    const auto sampled = [&](std::uint32_t i) {
        return begin + static_cast<std::uint32_t>(std::uint64_t{i} * (end - begin - 1) / count);
    };
    std::vector<double> steps;
    for (std::uint32_t i = 0; i < count; ++i)
        if (const double step = stepAt(octree, sampled(i), sampled(i + 1)); step > 0) steps.push_back(step);
    if (steps.empty()) return 0;
    const auto place = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), place, steps.end());
    return *place / kStepPerSpacing;
}

/// Offsets that hold the points [begin, end) of the octree's order: the boxes of the nodes within, and the
/// points of leaves that reach beyond.
class RangeBox {
  public:
    RangeBox(const Octree& octree, std::uint32_t begin, std::uint32_t end)
        : octree_(octree), begin_(begin), end_(end) {
        add(octree.nodes().front());
    }
    /// World; the corners are moved, so it holds what float offsets round away, too, but for its last bit.
    BoundingBox placed(const Similarity& worldFromLayer) const {
        const Eigen::Vector3d& origin = octree_.cloud().origin();
        BoundingBox box;
        box.add(Eigen::Vector3d(origin + min_.cast<double>()));
        box.add(Eigen::Vector3d(origin + max_.cast<double>()));
        return worldFromLayer.isIdentity() ? box : box.transformed(worldFromLayer);
    }

  private:
    void add(const Octree::Node& node) {
        if (node.end <= begin_ || node.begin >= end_) return;
        if (node.begin >= begin_ && node.end <= end_) return hold(node.min, node.max);
        for (std::uint32_t child = 0; child < node.childCount; ++child)
            add(octree_.nodes()[node.firstChild + child]);
        if (node.childCount > 0) return;
        for (std::uint32_t at = std::max(begin_, node.begin); at < std::min(end_, node.end); ++at) {
            const Eigen::Vector3f& offset = octree_.cloud().offsets()[octree_.order()[at]];
            hold(offset, offset);
        }
    }
    void hold(const Eigen::Vector3f& min, const Eigen::Vector3f& max) {
        min_ = any_ ? Eigen::Vector3f(min_.cwiseMin(min)) : min;
        max_ = any_ ? Eigen::Vector3f(max_.cwiseMax(max)) : max;
        any_ = true;
    }

    const Octree& octree_;
    std::uint32_t begin_;
    std::uint32_t end_;
    Eigen::Vector3f min_ = Eigen::Vector3f::Zero();
    Eigen::Vector3f max_ = Eigen::Vector3f::Zero();
    bool any_ = false;
};

}  // namespace

PointBlocks::PointBlocks(std::shared_ptr<const Octree> octree, const Similarity& worldFromLayer)
    : octree_(std::move(octree)) {
    const auto count = static_cast<std::uint32_t>(octree_->cloud().size());
    if (count == 0) return;
    blocks_.resize((std::size_t{count} + kSize - 1) / kSize);
    parallelFor(blocks_.size(), 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            PointBlock& block = blocks_[i];
            block.begin = static_cast<std::uint32_t>(i * kSize);
            block.end = static_cast<std::uint32_t>(std::min<std::size_t>(count, (i + 1) * kSize));
            block.box = RangeBox(*octree_, block.begin, block.end).placed(worldFromLayer);
            block.spacing_m = worldFromLayer.scale * medianSpacing(*octree_, block.begin, block.end);
        }
    });
    spacing_m_ = worldFromLayer.scale * typicalSpacing(*octree_);
    const std::uint32_t left = blocks_.back().size();
    if (left == kSize) return;
    lastRanks_.reserve(left);
    for (std::uint32_t i = 0; i < kSize; ++i)
        if (const std::uint32_t rank = reversedBits(i); rank < left)
            lastRanks_.push_back(static_cast<std::uint16_t>(rank));
}

std::uint32_t PointBlocks::point(std::size_t block, std::uint32_t rank) const {
    const bool partial = block + 1 == blocks_.size() && !lastRanks_.empty();
    return octree_->order()[blocks_[block].begin + (partial ? lastRanks_[rank] : reversedBits(rank))];
}

std::uint32_t pointsWorthDrawing(const PointBlock& block, double metresPerPixel) {
    // A share of the points of a surface stands farther apart by the root of that share; where several stand
    // in each place, it stands nearer, and no place is left out for it.
    const double apart_px = block.spacing_m / (kDensest_px * metresPerPixel);
    const double share = apart_px * apart_px;
    if (!(share < 1)) return block.size();
    return std::min(block.size(),
                    std::max(kLeastPoints, static_cast<std::uint32_t>(std::ceil(share * block.size()))));
}

}  // namespace vestige
