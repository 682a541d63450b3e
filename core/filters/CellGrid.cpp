#include "core/filters/CellGrid.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/filters/LoopProgress.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;

Eigen::Vector3d cellOf(const Eigen::Vector3d& world, double size) {
    return (world / size).array().floor();
}

}  // namespace

bool CellGrid::covers(const PointCloud& cloud, double size) {
    if (cloud.empty()) return true;
    const Eigen::Vector3d cells = cellOf(cloud.bounds().max, size) - cellOf(cloud.bounds().min, size);
    // One empty cell on either side.
    return cells.maxCoeff() + 3 <= static_cast<double>(kMostCells);
}

double CellGrid::coveringSize(const PointCloud& cloud, double size) {
    const double longest = cloud.bounds().extent().maxCoeff();
    return std::max(size, longest / static_cast<double>(kMostCells - 8));
}

CellGrid::CellGrid(const PointCloud& cloud, double size, const JobControl& control) : size_(size) {
    begins_.push_back(0);
    if (cloud.empty()) return;
    base_ = cellOf(cloud.bounds().min, size) - Eigen::Vector3d::Ones();
    std::vector<KeyedIndex> sorted =
        sortedByKey(cloud.size(), [&](std::size_t begin, std::span<std::uint64_t> keys) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            for (std::size_t i = 0; i < keys.size(); ++i) {
                const Eigen::Vector3d cell = cellOf(cloud.point(begin + i), size_) - base_;
                keys[i] = key(static_cast<std::uint64_t>(cell.x()), static_cast<std::uint64_t>(cell.y()),
                              static_cast<std::uint64_t>(cell.z()));
            }
        });
    const auto opensCell = [&](std::size_t i) { return i == 0 || sorted[i].key != sorted[i - 1].key; };
    std::vector<std::size_t> opened((sorted.size() + kGrain - 1) / kGrain);
    order_.resize(sorted.size());
    parallelChunks(sorted.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            order_[i] = sorted[i].index;
            opened[chunk] += opensCell(i);
        }
    });
    std::size_t cells = 0;
    for (std::size_t& many : opened) {
        const std::size_t before = cells;
        cells += many;
        many = before;
    }
    keys_.resize(cells);
    begins_.resize(cells + 1);
    parallelChunks(sorted.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::size_t cell = opened[chunk];
        for (std::size_t i = begin; i < end; ++i) {
            if (!opensCell(i)) continue;
            keys_[cell] = sorted[i].key;
            begins_[cell++] = static_cast<std::uint32_t>(i);
        }
    });
    begins_.back() = static_cast<std::uint32_t>(sorted.size());
}

Eigen::Vector3d CellGrid::corner(std::size_t cell) const {
    constexpr std::uint64_t kMask = kMostCells - 1;
    const std::uint64_t at = keys_[cell];
    const Eigen::Vector3d steps(static_cast<double>(at >> 42), static_cast<double>(at >> 21 & kMask),
                                static_cast<double>(at & kMask));
    return (base_ + steps) * size_;
}

std::size_t CellGrid::firstCell(std::uint64_t key) const {
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
}

}  // namespace vestige
