#include "core/registration/ndt/NormalDistributions.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <numbers>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::uint32_t kVotingPoints = 10;
constexpr double kPlaneWidth = 0.1;      // l1 >= 0.1 l0, or the cell is a line
constexpr double kSmallestShare = 0.01;  // eigenvalues are lifted to this share of the largest
constexpr double kInPlane = 1e-3;        // information left in the plane of a flat cell

struct Shape {
    NormalCell cell;
    double rootDeterminant = 0;  // 0: too few points or no extent
    bool votes = false;
    bool flat = false;
};

Shape shapeOf(const CellMoments& moments, const DistributionOptions& options) {
    Shape shape;
    if (moments.count < options.minimumPoints) return shape;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.scatterMatrix() /
                                                                (moments.count - 1.0));
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0);  // ascending
    const double largest = values[2];
    if (!(largest > 0)) return shape;
    const double noise = options.rangeNoise_m * options.rangeNoise_m;
    const bool wide = values[1] >= kPlaneWidth * largest;
    shape.flat = wide && std::max(0.0, values[0] - noise) <= options.flatness * values.sum();
    shape.votes = wide && moments.count >= kVotingPoints;

    const Eigen::Vector3d lifted = values.cwiseMax(kSmallestShare * largest);
    shape.rootDeterminant = std::sqrt(lifted.prod());
    Eigen::Vector3d weights = lifted.cwiseInverse();
    // In its plane a flat cell knows where its points were dense, not where the surface is: that differs from
    // scan to scan and would pull the source sideways.
    if (shape.flat && !options.flatCellsInPlane) weights.tail<2>() *= kInPlane;
    const Eigen::Matrix3d& axes = solver.eigenvectors();
    const Eigen::Matrix3f information = (axes * weights.asDiagonal() * axes.transpose()).cast<float>();
    shape.cell.key = moments.key;
    shape.cell.mean = moments.mean;
    shape.cell.information = {information(0, 0), information(0, 1), information(0, 2),
                              information(1, 1), information(1, 2), information(2, 2)};
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

double medianRootDeterminant(const std::vector<Shape>& shapes) {
    std::vector<double> values;
    for (const Shape& shape : shapes)
        if (shape.rootDeterminant > 0) values.push_back(shape.rootDeterminant);
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

NormalDistributions::NormalDistributions(std::span<const CellMoments> moments, const VoxelGrid& grid,
                                         const DistributionOptions& options)
    : grid_(grid) {
    std::vector<Shape> shapes(moments.size());
    parallelFor(moments.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) shapes[i] = shapeOf(moments[i], options);
    });
    flatness_.voxel_m = grid.size();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (shapes[i].rootDeterminant > 0) ++count_;
        if (!shapes[i].votes) continue;
        ++flatness_.cells;
        flatness_.points += moments[i].count;
        if (shapes[i].flat) ++flatness_.flat;
    }
    const auto [depth, steepness] =
        scoreShape(medianRootDeterminant(shapes), grid.size(), options.outlierRatio);
    table_.resize(std::bit_ceil(std::max<std::size_t>(16, 2 * count_)));
    mask_ = table_.size() - 1;
    for (Shape& shape : shapes) {
        if (!(shape.rootDeterminant > 0)) continue;
        shape.cell.depth = depth;
        shape.cell.steepness = steepness;
        std::size_t slot = VoxelGrid::hash(shape.cell.key) & mask_;
        while (table_[slot].key != VoxelGrid::kNoKey) slot = (slot + 1) & mask_;
        table_[slot] = shape.cell;
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
