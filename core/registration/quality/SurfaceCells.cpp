#include "core/registration/quality/SurfaceCells.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/registration/ndt/CellMoments.h"
#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {
namespace {

constexpr std::uint32_t kFewestPoints = 8;
constexpr double kFlat = 0.06;    // of the smallest eigenvalue in the sum: noise of a seventh of the voxel
constexpr double kNarrow = 0.08;  // of the middle eigenvalue in the largest: less is a line

double square(double x) {
    return x * x;
}

/// The voxels stand askew: floors and walls would else lie along voxel faces that cut their noise in two
/// halves, both off in the same direction over a whole room.
const Eigen::Matrix3d& askew() {
    static const Eigen::Matrix3d turn =
        Eigen::Quaterniond(0.9, 0.22, -0.31, 0.17).normalized().toRotationMatrix();
    return turn;
}

std::vector<CellMoments> gatherAskew(std::span<const Eigen::Vector3f> points, const VoxelGrid& grid) {
    constexpr std::size_t kGrain = 16384;
    const Eigen::Matrix3f turn = askew().cast<float>();
    std::vector<Eigen::Vector3f> turned(points.size());
    parallelFor(points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) turned[i] = turn * points[i];
    });
    return gatherPoints(turned, grid);
}

bool planar(const CellMoments& moments, double size, SurfaceCell& cell) {
    if (moments.count < kFewestPoints) return false;
    const double n = moments.count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.scatterMatrix() / (n - 1));
    const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0);
    if (values[0] > kFlat * values.sum() || values[1] < kNarrow * values[2]) return false;
    cell.mean = askew().transpose() * moments.meanVector();
    cell.normal = askew().transpose() * solver.eigenvectors().col(0);
    cell.wide = askew().transpose() * solver.eigenvectors().col(2);
    cell.thickness_m = std::sqrt(values[0]);
    cell.wide_m = std::sqrt(values[2]);
    cell.narrow_m = std::sqrt(values[1]);
    cell.size_m = size;
    // A filled rectangle of these standard deviations.
    cell.area_m2 = std::min(12 * cell.wide_m * cell.narrow_m, 2 * square(size));
    cell.count = n;
    return true;
}

}  // namespace

double SurfaceCell::planeVariance(const Eigen::Vector3d& offset) const {
    const double along = offset.dot(wide);
    const double across = offset.dot(wide.cross(normal));
    return square(thickness_m) / count * (1 + square(along / wide_m) + square(across / narrow_m));
}

std::vector<SurfaceCell> surfaceCells(std::span<const Eigen::Vector3f> points, double finest_m, int levels) {
    std::vector<SurfaceCell> cells;
    double size = finest_m;
    std::vector<CellMoments> moments = gatherAskew(points, VoxelGrid(size));
    for (int level = 0; level < levels; ++level, size *= 2) {
        if (level > 0) moments = gatherCells(moments, VoxelGrid(size));
        std::vector<CellMoments> left;
        for (const CellMoments& one : moments) {
            SurfaceCell cell;
            if (planar(one, size, cell))
                cells.push_back(cell);
            else
                left.push_back(one);
        }
        moments = std::move(left);
    }
    return cells;
}

double flattestQuarter(std::span<const Eigen::Vector3f> points, double size_m) {
    std::vector<double> thicknesses;
    for (const CellMoments& one : gatherAskew(points, VoxelGrid(size_m))) {
        if (one.count < kFewestPoints) continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(one.scatterMatrix() / (one.count - 1.0),
                                                                    Eigen::EigenvaluesOnly);
        if (solver.eigenvalues()[1] > kNarrow * solver.eigenvalues()[2])
            thicknesses.push_back(std::sqrt(std::max(0.0, solver.eigenvalues()[0])));
    }
    if (thicknesses.empty()) return 0;
    const auto quarter = thicknesses.begin() + static_cast<std::ptrdiff_t>(thicknesses.size() / 4);
    std::nth_element(thicknesses.begin(), quarter, thicknesses.end());
    return *quarter;
}

SurfaceIndex::SurfaceIndex(std::vector<SurfaceCell> cells, double finest_m, int levels)
    : cells_(std::move(cells)), finest_m_(finest_m), levels_(static_cast<std::size_t>(levels)) {
    const auto levelOf = [&](const SurfaceCell& cell) {
        return static_cast<std::size_t>(std::lround(std::log2(cell.size_m / finest_m_)));
    };
    std::vector<std::size_t> counts(levels_.size(), 0);
    for (const SurfaceCell& cell : cells_) ++counts[levelOf(cell)];
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        levels_[i].table.assign(std::bit_ceil(2 * 27 * counts[i] + 1), {VoxelGrid::kNoKey, 0});
        levels_[i].mask = static_cast<std::uint32_t>(levels_[i].table.size() - 1);
    }
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
        const Eigen::Vector3d mean = askew() * cells_[i].mean;
        const std::uint64_t middle = VoxelGrid(cells_[i].size_m).key(mean.x(), mean.y(), mean.z());
        Level& level = levels_[levelOf(cells_[i])];
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const std::uint64_t key = VoxelGrid::neighbour(middle, dx, dy, dz);
                    if (key == VoxelGrid::kNoKey) continue;
                    std::uint32_t slot = VoxelGrid::hash(key) & level.mask;
                    while (level.table[slot].key != VoxelGrid::kNoKey) slot = (slot + 1) & level.mask;
                    level.table[slot] = {key, i};
                }
    }
}

const SurfaceCell* SurfaceIndex::over(const Eigen::Vector3d& x, const Eigen::Vector3d& normal, double cosine,
                                      const SurfaceCell** any) const {
    constexpr double kReach = 0.75;
    const Eigen::Vector3d turned = askew() * x;
    double size = finest_m_;
    const SurfaceCell* across = nullptr;
    for (const Level& level : levels_) {
        const std::uint64_t key = VoxelGrid(size).key(turned.x(), turned.y(), turned.z());
        const SurfaceCell* best = nullptr;
        const SurfaceCell* bestAny = nullptr;
        double nearest = 0, nearestAny = 0;
        const auto look = [&](const SurfaceCell& cell) {
            const Eigen::Vector3d offset = x - cell.mean;
            const double height = std::abs(offset.dot(cell.normal));
            if (offset.squaredNorm() - height * height > square(kReach * size) || height > kReach * size)
                return;
            if (std::abs(cell.normal.dot(normal)) >= cosine) {
                if (!best || height < nearest) {
                    best = &cell;
                    nearest = height;
                }
            } else if (!bestAny || height < nearestAny) {
                bestAny = &cell;
                nearestAny = height;
            }
        };
        if (key != VoxelGrid::kNoKey)
            for (std::uint32_t slot = VoxelGrid::hash(key) & level.mask;
                 level.table[slot].key != VoxelGrid::kNoKey; slot = (slot + 1) & level.mask)
                if (level.table[slot].key == key) look(cells_[level.table[slot].cell]);
        if (best) return best;
        if (!across) across = bestAny;
        size *= 2;
    }
    if (any) *any = across;
    return nullptr;
}

}  // namespace vestige
