#include "core/registration/ndt/NormalDistributions.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <numbers>

#include "core/base/Parallel.h"
#include "core/registration/ndt/EigenLanes.h"

namespace vestige {
namespace {

constexpr std::uint32_t kVotingPoints = 10;
constexpr float kPlaneWidth = 0.1F;  // l1 >= 0.1 l0, or the cell is a line

constexpr float kInPlane = 1e-3F;  // information left in the plane of a flat cell
constexpr std::size_t kLanes = 8;

/// Per-cell results of eight moments at once.
struct ShapeLanes {
    alignas(32) std::array<float, kLanes> rootDeterminant{};  // 0: no extent
    alignas(32) std::array<float, kLanes> thickness{};
    alignas(32) std::array<std::array<float, kLanes>, 6> information{};
    unsigned wide = 0;  // bit masks
    unsigned flat = 0;
};

ShapeLanes shapesOf(std::span<const CellMoments> moments, const DistributionOptions& options) {
    alignas(32) std::array<std::array<float, kLanes>, 6> covariance{};
    for (std::size_t lane = 0; lane < moments.size(); ++lane) {
        const float perPoint = 1.0F / static_cast<float>(std::max(2U, moments[lane].count) - 1);
        for (std::size_t i = 0; i < 6; ++i) covariance[i][lane] = moments[lane].scatter[i] * perPoint;
    }
    const auto given = [&](std::size_t i) { return Lanes::load(covariance[i].data()); };
    EigenLanes eigen = eigenOf(given(0), given(1), given(2), given(3), given(4), given(5));
    const Lanes zero = Lanes::zero();
    for (Lanes& value : eigen.values) value = max(value, zero);
    const Lanes largest = eigen.values[2];
    const Lanes sum = eigen.values[0] + eigen.values[1] + eigen.values[2];
    const auto noise = static_cast<float>(options.rangeNoise_m * options.rangeNoise_m);
    const Lanes excess = max(zero, eigen.values[0] - Lanes::of(noise));
    const auto bits = [](Lanes mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask.v)); };
    ShapeLanes shape;
    const unsigned extent = bits(below(zero, largest));
    shape.wide = extent & ~bits(below(eigen.values[1], Lanes::of(kPlaneWidth) * largest));
    shape.flat = shape.wide & ~bits(below(Lanes::of(static_cast<float>(options.flatness)) * sum, excess));
    sqrt(eigen.values[0]).store(shape.thickness.data());

    const Lanes floor =
        max(Lanes::of(static_cast<float>(options.leastDeviation_m * options.leastDeviation_m)),
            Lanes::of(static_cast<float>(options.leastShare * options.leastShare)) * largest);
    const Lanes lifted[3] = {max(eigen.values[0], floor), max(eigen.values[1], floor), max(largest, floor)};
    // One root at a time: the product of small things' eigenvalues is no float.
    (sqrt(lifted[0]) * sqrt(lifted[1]) * sqrt(lifted[2])).store(shape.rootDeterminant.data());
    // In its plane a flat cell knows where its points were dense, not where the surface is: that differs from
    // scan to scan and would pull the source sideways.
    alignas(32) std::array<float, kLanes> inPlane;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
        inPlane[lane] = (shape.flat >> lane & 1U) != 0 && !options.flatCellsInPlane ? kInPlane : 1.0F;
    const Lanes share = Lanes::load(inPlane.data());
    const Lanes weights[3] = {Lanes::of(1) / lifted[0], share / lifted[1], share / lifted[2]};
    constexpr int kEntries[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
    for (std::size_t i = 0; i < 6; ++i) {
        const auto [row, column] = kEntries[i];
        Lanes entry = zero;
        for (int k = 0; k < 3; ++k)
            entry = fma(weights[k] * eigen.vectors[k][row], eigen.vectors[k][column], entry);
        entry.store(shape.information[i].data());
    }
    const unsigned kept = options.flatOnly ? shape.flat : extent;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
        if ((kept >> lane & 1U) == 0) shape.rootDeterminant[lane] = 0;
    return shape;
}

/// d1 and d2 of the Gaussian that stands for -log(c1 exp(-q/2) + c2), both of unit mass in the cell.
std::pair<float, float> scoreShape(double rootDeterminant, double size, double outlierRatio) {
    const double c2 = outlierRatio / (size * size * size);
    const double c1 = (1 - outlierRatio) / (std::pow(2 * std::numbers::pi, 1.5) * rootDeterminant);
    const double d3 = -std::log(c2);
    const double d1 = -std::log(c1 + c2) - d3;
    const double d2 = -2 * std::log((-std::log(c1 * std::exp(-0.5) + c2) - d3) / d1);
    return {static_cast<float>(d1), static_cast<float>(d2)};
}

double median(std::vector<float> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

}  // namespace

NormalDistributions::NormalDistributions(std::span<const CellMoments> moments, const VoxelGrid& grid,
                                         const DistributionOptions& options)
    : grid_(grid) {
    std::vector<CellMoments> enough;
    enough.reserve(moments.size());
    for (const CellMoments& cell : moments)
        if (cell.count >= options.minimumPoints) enough.push_back(cell);
    std::vector<NormalCell> cells(enough.size());
    std::vector<float> determinants(enough.size());
    std::vector<char> votes(enough.size());
    parallelFor(enough.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t from = begin; from < end; from += kLanes) {
            const auto few = std::span(enough).subspan(from, std::min(kLanes, end - from));
            const ShapeLanes shape = shapesOf(few, options);
            for (std::size_t lane = 0; lane < few.size(); ++lane) {
                NormalCell& cell = cells[from + lane];
                cell.key = few[lane].key;
                cell.mean = few[lane].mean;
                for (std::size_t i = 0; i < 6; ++i) cell.information[i] = shape.information[i][lane];
                cell.count = few[lane].count;
                cell.thickness = shape.thickness[lane];
                cell.flat = (shape.flat >> lane & 1U) != 0;
                determinants[from + lane] = shape.rootDeterminant[lane];
                votes[from + lane] = (shape.wide >> lane & 1U) != 0 && few[lane].count >= kVotingPoints;
            }
        }
    });
    flatness_.voxel_m = grid.size();
    std::vector<float> positive;
    positive.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (determinants[i] > 0) positive.push_back(determinants[i]);
        if (!votes[i]) continue;
        ++flatness_.cells;
        flatness_.points += cells[i].count;
        if (!cells[i].flat) continue;
        ++flatness_.flat;
        flatness_.flatPoints += cells[i].count;
    }
    count_ = positive.size();
    const auto [depth, steepness] =
        scoreShape(median(std::move(positive)), grid.size(), options.outlierRatio);
    table_.resize(std::bit_ceil(std::max<std::size_t>(16, 2 * count_)));
    keys_.assign(table_.size(), VoxelGrid::kNoKey);
    mask_ = static_cast<std::uint32_t>(table_.size() - 1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!(determinants[i] > 0)) continue;
        cells[i].depth = depth;
        cells[i].steepness = steepness;
        std::uint32_t slot = VoxelGrid::hash(cells[i].key) & mask_;
        while (keys_[slot] != VoxelGrid::kNoKey) slot = (slot + 1) & mask_;
        table_[slot] = cells[i];
        keys_[slot] = cells[i].key;
    }
}

double surfaceThickness(std::span<const CellMoments> moments) {
    std::vector<double> thickness;
    for (const CellMoments& cell : moments) {
        if (cell.count < kVotingPoints) continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(cell.scatterMatrix() / (cell.count - 1.0),
                                                                    Eigen::EigenvaluesOnly);
        const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0);
        if (values[1] >= kPlaneWidth * values[2]) thickness.push_back(std::sqrt(values[0]));
    }
    if (thickness.empty()) return 0;
    const auto quarter = thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 4);
    std::nth_element(thickness.begin(), quarter, thickness.end());
    return *quarter;
}

}  // namespace vestige
