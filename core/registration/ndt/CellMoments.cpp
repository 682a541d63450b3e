#include "core/registration/ndt/CellMoments.h"

#include <cstddef>

#include "core/base/Parallel.h"
#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 16384;

/// Sums round the centre of a voxel, in double: small numbers, so that nothing cancels.
struct Sums {
    std::uint64_t key;
    double count = 0;
    std::array<double, 3> first{};
    std::array<double, 6> second{};
};

struct PointInput {
    std::span<const Eigen::Vector3f> points;
    std::size_t size() const { return points.size(); }
    std::uint64_t key(const VoxelGrid& grid, std::size_t i) const {
        return grid.key(points[i].x(), points[i].y(), points[i].z());
    }
    void addTo(Sums& sums, const VoxelGrid& grid, std::size_t i) const {
        const double x = points[i].x() - grid.centreX(sums.key);
        const double y = points[i].y() - grid.centreY(sums.key);
        const double z = points[i].z() - grid.centreZ(sums.key);
        sums.count += 1;
        sums.first[0] += x;
        sums.first[1] += y;
        sums.first[2] += z;
        sums.second[0] += x * x;
        sums.second[1] += x * y;
        sums.second[2] += x * z;
        sums.second[3] += y * y;
        sums.second[4] += y * z;
        sums.second[5] += z * z;
    }
};

struct CellInput {
    std::span<const CellMoments> cells;
    std::size_t size() const { return cells.size(); }
    std::uint64_t key(const VoxelGrid& grid, std::size_t i) const {
        return grid.key(cells[i].mean[0], cells[i].mean[1], cells[i].mean[2]);
    }
    void addTo(Sums& sums, const VoxelGrid& grid, std::size_t i) const {
        const CellMoments& cell = cells[i];
        const double n = cell.count;
        const double x = cell.mean[0] - grid.centreX(sums.key);
        const double y = cell.mean[1] - grid.centreY(sums.key);
        const double z = cell.mean[2] - grid.centreZ(sums.key);
        sums.count += n;
        sums.first[0] += n * x;
        sums.first[1] += n * y;
        sums.first[2] += n * z;
        sums.second[0] += cell.scatter[0] + n * x * x;
        sums.second[1] += cell.scatter[1] + n * x * y;
        sums.second[2] += cell.scatter[2] + n * x * z;
        sums.second[3] += cell.scatter[3] + n * y * y;
        sums.second[4] += cell.scatter[4] + n * y * z;
        sums.second[5] += cell.scatter[5] + n * z * z;
    }
};

CellMoments finished(const Sums& sums, const VoxelGrid& grid) {
    const double n = sums.count;
    const auto& [x, y, z] = sums.first;
    const auto toFloat = [](double value) { return static_cast<float>(value); };
    return {sums.key,
            static_cast<std::uint32_t>(n),
            {toFloat(grid.centreX(sums.key) + x / n), toFloat(grid.centreY(sums.key) + y / n),
             toFloat(grid.centreZ(sums.key) + z / n)},
            {toFloat(sums.second[0] - x * x / n), toFloat(sums.second[1] - x * y / n),
             toFloat(sums.second[2] - x * z / n), toFloat(sums.second[3] - y * y / n),
             toFloat(sums.second[4] - y * z / n), toFloat(sums.second[5] - z * z / n)}};
}

/// Open addressing from key to the place in a growing list.
class KeyIndex {
  public:
    KeyIndex() : slots_(64, {VoxelGrid::kNoKey, 0}) {}
    std::uint32_t placeOf(std::uint64_t key, std::vector<Sums>& sums) {
        if (2 * (sums.size() + 1) > slots_.size()) grow();
        std::size_t slot = VoxelGrid::hash(key) & (slots_.size() - 1);
        while (slots_[slot].key != key) {
            if (slots_[slot].key == VoxelGrid::kNoKey) {
                slots_[slot] = {key, static_cast<std::uint32_t>(sums.size())};
                sums.push_back({key, 0, {}, {}});
                break;
            }
            slot = (slot + 1) & (slots_.size() - 1);
        }
        return slots_[slot].place;
    }

  private:
    struct Slot {
        std::uint64_t key;
        std::uint32_t place;
    };
    void grow() {
        std::vector<Slot> old(2 * slots_.size(), {VoxelGrid::kNoKey, 0});
        old.swap(slots_);
        for (const Slot& one : old) {
            if (one.key == VoxelGrid::kNoKey) continue;
            std::size_t slot = VoxelGrid::hash(one.key) & (slots_.size() - 1);
            while (slots_[slot].key != VoxelGrid::kNoKey) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = one;
        }
    }
    std::vector<Slot> slots_;
};

template <class Input>
std::vector<CellMoments> gatherBucket(const Input& input, const VoxelGrid& grid,
                                      std::span<const std::uint32_t> items,
                                      std::span<const std::uint64_t> keys) {
    KeyIndex index;
    std::vector<Sums> sums;
    for (const std::uint32_t i : items) input.addTo(sums[index.placeOf(keys[i], sums)], grid, i);
    std::vector<CellMoments> cells;
    cells.reserve(sums.size());
    for (const Sums& one : sums) cells.push_back(finished(one, grid));
    return cells;
}

/// Items go to buckets by their key's hash, in input order; a bucket holds all items of its voxels, so each
/// voxel's sum runs in input order whatever thread has the bucket.
template <class Input>
std::vector<CellMoments> gather(const Input& input, const VoxelGrid& grid) {
    const std::size_t count = input.size();
    const std::size_t buckets = count < 2 * kGrain ? 1 : count < 64 * kGrain ? 16 : 256;
    const std::size_t chunks = (count + kGrain - 1) / kGrain;
    const auto bucketOf = [&](std::uint64_t key) { return (VoxelGrid::hash(key) >> 40) % buckets; };

    std::vector<std::uint64_t> keys(count);
    std::vector<std::uint32_t> places(chunks * buckets, 0);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            keys[i] = input.key(grid, i);
            if (keys[i] != VoxelGrid::kNoKey) ++places[bucketOf(keys[i]) * chunks + chunk];
        }
    });
    std::uint32_t total = 0;
    for (std::uint32_t& place : places) {
        const std::uint32_t here = place;
        place = total;
        total += here;
    }
    std::vector<std::size_t> begins(buckets + 1, total);
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
        if (chunks > 0) begins[bucket] = places[bucket * chunks];
    std::vector<std::uint32_t> items(total);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (keys[i] != VoxelGrid::kNoKey)
                items[places[bucketOf(keys[i]) * chunks + chunk]++] = static_cast<std::uint32_t>(i);
    });
    std::vector<std::vector<CellMoments>> parts(buckets);
    parallelFor(buckets, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t bucket = begin; bucket < end; ++bucket)
            parts[bucket] = gatherBucket(
                input, grid, std::span(items).subspan(begins[bucket], begins[bucket + 1] - begins[bucket]),
                keys);
    });
    std::vector<CellMoments> cells;
    for (const auto& part : parts) cells.insert(cells.end(), part.begin(), part.end());
    return cells;
}

}  // namespace

Eigen::Matrix3d CellMoments::scatterMatrix() const {
    Eigen::Matrix3d matrix;
    matrix << scatter[0], scatter[1], scatter[2], scatter[1], scatter[3], scatter[4], scatter[2], scatter[4],
        scatter[5];
    return matrix;
}

std::vector<CellMoments> gatherPoints(std::span<const Eigen::Vector3f> points, const VoxelGrid& grid) {
    return gather(PointInput{points}, grid);
}

std::vector<CellMoments> gatherCells(std::span<const CellMoments> cells, const VoxelGrid& grid) {
    return gather(CellInput{cells}, grid);
}

MomentPyramid::MomentPyramid(std::span<const Eigen::Vector3f> points, double finest, double coarsest)
    : baseSize_(finest / 4) {
    stages_.push_back(gatherPoints(points, VoxelGrid(baseSize_)));
    for (double size = 2 * baseSize_; size <= coarsest / 4; size *= 2)
        stages_.push_back(gatherCells(stages_.back(), VoxelGrid(size)));
}

std::span<const CellMoments> MomentPyramid::finerThan(double size) const {
    std::size_t stage = 0;
    while (stage + 1 < stages_.size() && std::ldexp(baseSize_, static_cast<int>(stage) + 1) <= size) ++stage;
    return stages_[stage];
}

std::vector<CellMoments> MomentPyramid::at(const VoxelGrid& grid) const {
    return gatherCells(finerThan(grid.size() / 4), grid);
}

}  // namespace vestige
