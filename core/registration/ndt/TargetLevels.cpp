#include "core/registration/ndt/TargetLevels.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/registration/ndt/VoxelSchedule.h"

namespace vestige {
namespace {

constexpr double kPublishedFactor = 0.8;
constexpr double kFactor = 0.5;
/// Whole cells bring the pose near enough for the surfaces at this share of v0; smaller ones add nothing.
constexpr double kLastWhole = 1.0 / 4;
/// As every point counts in the smallest cell that holds it, v_n may leave most points to larger ones.
constexpr double kVotingShare = 0.1;
/// The largest flat cells against v0: larger ones drag on lawns by centimetres.
constexpr double kLargestFlat = 1.0 / 4;
/// What lies beside the surfaces must not pull: the larger the share of outliers, the earlier the score falls
/// off.
constexpr double kBesideSurfaces = 0.8;
/// Flat cells that hold less than this share of the target cannot hold the source.
constexpr double kLeastFlat = 0.15;
/// A surface is as thin as its points lie; cells of few points may look thinner than any scanner measures.
constexpr double kLeastThickness = 0.0125;

double finestOf(const ImprovedNdtOptions& options) {
    return options.voxel_m.value_or(options.voxelFloor_m);
}

}  // namespace

/// The publication's sizes do not nest, nor do shifted grids: their cells are merged from smaller ones.
double TargetLevels::finestCell(const ImprovedNdtOptions& options) {
    return options.published || options.shiftedGrids > 1 ? finestOf(options) / 4 : finestOf(options);
}

TargetLevels::TargetLevels(std::span<const Eigen::Vector3f> target, const ImprovedNdtOptions& options)
    : options_(options),
      pyramid_(target, finestCell(options), std::max(options.voxelStart_m, finestOf(options))) {
    if (options.estimateNoise) {
        options_.distributions.rangeNoise_m = surfaceThickness(pyramid_.at(VoxelGrid(options.voxelStart_m)));
        notes_.push_back("Range noise of the target taken as " +
                         fixedText(1000 * options_.distributions.rangeNoise_m, 1) + " mm");
    }
    choose(target.size());
}

/// Steps 1 and 2 of METHOD section 3: the distributions at each size of the schedule, v_n where it is not
/// given.
void TargetLevels::choose(std::size_t targetPoints) {
    std::vector<FlatnessCount> counts;
    const double finest = finestOf(options_);
    const double factor = options_.published ? kPublishedFactor : kFactor;
    const double share = options_.published ? 0.5 : kVotingShare;
    std::vector<NormalDistributions> cells;
    for (const double size : voxelSchedule(std::max(options_.voxelStart_m, finest), finest, factor)) {
        cells.push_back(at(VoxelGrid(size), options_.distributions));
        counts.push_back(cells.back().flatness());
        if (!options_.voxel_m && pastLeastShare(counts, targetPoints, share)) break;
    }
    std::size_t chosen = cells.size() - 1;
    if (!options_.voxel_m) {
        chosen = finestByFlatness(counts, targetPoints, options_.voxelCeiling_m, share);
        notes_.push_back("Smallest voxel " + fixedText(counts[chosen].voxel_m, 3) + " m, where " +
                         fixedText(100 * counts[chosen].ratio(), 0) + " % of the target's cells are flat");
    }
    smallest_ = counts[chosen].voxel_m;
    std::size_t flat = 0;
    for (const FlatnessCount& count : counts) flat = std::max(flat, count.flatPoints);
    flatHold_ = static_cast<double>(flat) >= kLeastFlat * static_cast<double>(targetPoints);
    for (std::size_t i = 0; i <= chosen; ++i) {
        const double size = counts[i].voxel_m;
        const double least = std::max(kLastWhole * options_.voxelStart_m * (1 - 1e-9), 1.5 * smallest_);
        if (!options_.published && i > 0 && size < least) break;
        sizes_.push_back(size);
        if (!options_.published && i == 0)
            cells_.push_back(at(VoxelGrid(size, size / 2), options_.distributions));
        cells_.push_back(std::move(cells[i]));
    }
}

std::span<const NormalDistributions> TargetLevels::seen(std::size_t level) const {
    return options_.published ? std::span(cells_).subspan(level, 1) : std::span(cells_).first(level + 2);
}

NormalDistributions TargetLevels::at(const VoxelGrid& grid, const DistributionOptions& options) const {
    if (const std::vector<CellMoments>* const stage = pyramid_.stage(grid)) return {*stage, grid, options};
    return {pyramid_.at(grid), grid, options};
}

DistributionOptions TargetLevels::surfaceOptions(double deviation_m) const {
    DistributionOptions options = options_.distributions;
    options.flatOnly = flatHold_;
    options.outlierRatio = std::max(options.outlierRatio, kBesideSurfaces);
    options.leastShare = kLeastThickness;
    options.leastDeviation_m = deviation_m;
    return options;
}

std::vector<NormalDistributions> TargetLevels::surfaces(double deviation_m, double finest) const {
    std::vector<double> sizes{finest};
    while (2 * sizes.back() <= largestSurface() * (1 + 1e-9)) sizes.push_back(2 * sizes.back());
    std::vector<NormalDistributions> levels;
    for (std::size_t i = sizes.size(); i-- > 0;) {
        if (i + 1 == sizes.size())
            levels.push_back(at(VoxelGrid(sizes[i], sizes[i] / 2), surfaceOptions(deviation_m)));
        levels.push_back(at(VoxelGrid(sizes[i]), surfaceOptions(deviation_m)));
    }
    return levels;
}

double TargetLevels::largestSurface() const {
    return std::max(smallest_, kLargestFlat * options_.voxelStart_m);
}

std::vector<NormalDistributions> TargetLevels::shiftedSurfaces(double deviation_m) const {
    std::vector<NormalDistributions> shifted;
    for (int i = 1; i < options_.shiftedGrids; ++i) {
        const VoxelGrid grid(smallest_, smallest_ * i / options_.shiftedGrids);
        shifted.push_back(at(grid, surfaceOptions(deviation_m)));
    }
    return shifted;
}

}  // namespace vestige
