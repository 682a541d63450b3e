#include "core/filters/CellGrid.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/base/Result.h"
#include "core/filters/WorldPoints.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
}  // namespace

CellGrid::CellGrid(const PointCloud& cloud, double size, const JobControl& control) {
    members_.begins.push_back(0);
    if (cloud.empty()) return;
    layout_ = CellLayout(cloud.bounds(), size);
    // Half the memory and time for the sort where the cloud allows.
    if (layout_.keyBits() <= 32) {
        sortPoints<std::uint32_t>(cloud, control);
    } else {
        sortPoints<std::uint64_t>(cloud, control);
    }
}

template <class Key>
void CellGrid::sortPoints(const PointCloud& cloud, const JobControl& control) {
    const WorldPoints points(cloud);
    const double perSize = 1 / size();
    const LargeArray<KeyedIndex<Key>> sorted =
        sortedByKey<Key>(cloud.size(), layout_.keyBits(), [&](std::size_t begin, std::span<Key> keys) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            const auto steps = [&](int axis, std::size_t i) {
                return static_cast<std::uint64_t>(CellLayout::cellOf(points.along(axis, i), perSize) -
                                                  layout_.base()[axis]);
            };
            for (std::size_t i = 0; i < keys.size(); ++i)
                keys[i] =
                    static_cast<Key>(key(steps(0, begin + i), steps(1, begin + i), steps(2, begin + i)));
        });
    const auto opensCell = [&](std::size_t i) { return i == 0 || sorted[i].key != sorted[i - 1].key; };
    std::vector<std::size_t> opened((sorted.size() + kGrain - 1) / kGrain);
    members_.order.resize(sorted.size());
    parallelChunks(sorted.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::size_t many = 0;
        for (std::size_t i = begin; i < end; ++i) {
            members_.order[i] = sorted[i].index;
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
    members_.begins.resize(cells + 1);
    parallelChunks(sorted.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        std::size_t cell = opened[chunk];
        for (std::size_t i = begin; i < end; ++i) {
            if (!opensCell(i)) continue;
            keys_[cell] = sorted[i].key;
            members_.begins[cell++] = static_cast<std::uint32_t>(i);
        }
    });
    members_.begins.back() = static_cast<std::uint32_t>(sorted.size());
}

std::size_t CellGrid::firstCell(std::uint64_t key) const {
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
}

}  // namespace vestige
