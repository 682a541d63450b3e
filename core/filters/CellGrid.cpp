#include "core/filters/CellGrid.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/filters/LoopProgress.h"
#include "core/filters/WorldPoints.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
/// Coordinates in cells up to here have their whole number and half a cell or better.
constexpr double kFarthestCell = 1ULL << 52;

using Cell = Eigen::Array<std::int64_t, 3, 1>;

/// std::floor for numbers that fit, without the call that it costs on the oldest x86-64.
inline std::int64_t floored(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    return whole - (static_cast<double>(whole) > value);
}

inline Cell cellOf(const Eigen::Vector3d& world, double perSize) {
    return {floored(world.x() * perSize), floored(world.y() * perSize), floored(world.z() * perSize)};
}

double farthest(const PointCloud& cloud) {
    return cloud.bounds().min.cwiseAbs().cwiseMax(cloud.bounds().max.cwiseAbs()).maxCoeff();
}

}  // namespace

bool CellGrid::covers(const PointCloud& cloud, double size) {
    if (cloud.empty()) return true;
    if (!(farthest(cloud) / size < kFarthestCell)) return false;
    const Cell cells = cellOf(cloud.bounds().max, 1 / size) - cellOf(cloud.bounds().min, 1 / size);
    // One empty cell on either side.
    return cells.maxCoeff() + 3 <= static_cast<std::int64_t>(kMostCells);
}

double CellGrid::coveringSize(const PointCloud& cloud, double size) {
    if (cloud.empty()) return size;
    const double longest = cloud.bounds().extent().maxCoeff();
    return std::max(
        {size, longest / static_cast<double>(kMostCells - 8), 2 * farthest(cloud) / kFarthestCell});
}

CellGrid::CellGrid(const PointCloud& cloud, double size, const JobControl& control) : size_(size) {
    begins_.push_back(0);
    if (cloud.empty()) return;
    base_ = cellOf(cloud.bounds().min, 1 / size) - 1;
    const Cell last = cellOf(cloud.bounds().max, 1 / size) - base_ + 1;
    const auto bits = [&](int axis) {
        return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(last[axis])));
    };
    shiftY_ = bits(2);
    shiftX_ = shiftY_ + bits(1);
    const unsigned keyBits = shiftX_ + bits(0);
    // Half the memory and time for the sort where the cloud allows.
    if (keyBits <= 32) {
        sortPoints<std::uint32_t>(cloud, keyBits, control);
    } else {
        sortPoints<std::uint64_t>(cloud, keyBits, control);
    }
}

template <class Key>
void CellGrid::sortPoints(const PointCloud& cloud, unsigned keyBits, const JobControl& control) {
    const WorldPoints points(cloud);
    const double perSize = 1 / size_;
    const std::vector<KeyedIndex<Key>> sorted =
        sortedByKey<Key>(cloud.size(), keyBits, [&](std::size_t begin, std::span<Key> keys) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            const auto steps = [&](int axis, std::size_t i) {
                return static_cast<std::uint64_t>(floored(points.along(axis, i) * perSize) - base_[axis]);
            };
            for (std::size_t i = 0; i < keys.size(); ++i)
                keys[i] =
                    static_cast<Key>(key(steps(0, begin + i), steps(1, begin + i), steps(2, begin + i)));
        });
    const auto opensCell = [&](std::size_t i) { return i == 0 || sorted[i].key != sorted[i - 1].key; };
    std::vector<std::size_t> opened((sorted.size() + kGrain - 1) / kGrain);
    order_.resize(sorted.size());
    parallelChunks(sorted.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::size_t many = 0;
        for (std::size_t i = begin; i < end; ++i) {
            order_[i] = sorted[i].index;
            many += opensCell(i);
        }
        opened[chunk] = many;
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
    const std::uint64_t at = keys_[cell];
    const std::uint64_t maskY = (std::uint64_t{1} << (shiftX_ - shiftY_)) - 1;
    const std::uint64_t maskZ = (std::uint64_t{1} << shiftY_) - 1;
    const Cell steps(static_cast<std::int64_t>(at >> shiftX_),
                     static_cast<std::int64_t>(at >> shiftY_ & maskY), static_cast<std::int64_t>(at & maskZ));
    return (base_ + steps).cast<double>().matrix() * size_;
}

std::size_t CellGrid::firstCell(std::uint64_t key) const {
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
}

}  // namespace vestige
