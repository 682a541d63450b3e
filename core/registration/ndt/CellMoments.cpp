#include "core/registration/ndt/CellMoments.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cstddef>

#include "core/base/Parallel.h"
#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 16384;
constexpr int kBlockBits = 4;

/// Sums round the centre of a voxel, in double: small numbers, so that nothing cancels.
struct alignas(32) Sums {
    std::array<double, 4> first{};   // x, y, z, count
    std::array<double, 4> second{};  // xx, xy, xz, yy
    std::array<double, 2> rest{};    // yz, zz
    std::uint64_t key = VoxelGrid::kNoKey;
};

__m128 threeFloats(const float* from) {
    return _mm_maskload_ps(from, _mm_setr_epi32(-1, -1, -1, 0));
}

struct PointInput {
    std::span<const Eigen::Vector3f> points;
    std::size_t size() const { return points.size(); }
    /// VoxelGrid::key, the axes at once.
    void keys(const VoxelGrid& grid, std::size_t begin, std::size_t end, std::uint64_t* keys) const {
        const __m256d shift = _mm256_set1_pd(grid.shift()), scale = _mm256_set1_pd(grid.perMetre());
        const __m128i half = _mm_set1_epi32(static_cast<int>(VoxelGrid::kHalf));
        const __m128i outside = _mm_set1_epi32(~static_cast<int>(VoxelGrid::kMask));
        for (std::size_t i = begin; i < end; ++i) {
            const __m256d x = _mm256_cvtps_pd(threeFloats(points[i].data()));
            const __m128i index = _mm_add_epi32(
                _mm256_cvttpd_epi32(_mm256_floor_pd(_mm256_mul_pd(_mm256_add_pd(x, shift), scale))), half);
            const auto low = static_cast<std::uint64_t>(_mm_cvtsi128_si64(index));
            const auto z = static_cast<std::uint64_t>(_mm_extract_epi32(index, 2));
            const std::uint64_t key = (low & 0xffffffff) | low >> 32 << 21 | z << 42;
            keys[i] = _mm_testz_si128(index, outside) != 0 ? key : VoxelGrid::kNoKey;
        }
    }
    void addTo(Sums& sums, const VoxelGrid& grid, std::span<const std::uint32_t> items) const {
        const __m256d centre =
            _mm256_setr_pd(grid.centreX(sums.key), grid.centreY(sums.key), grid.centreZ(sums.key), -1);
        __m256d first = _mm256_load_pd(sums.first.data());
        __m256d second = _mm256_load_pd(sums.second.data());
        __m128d rest = _mm_load_pd(sums.rest.data());
        for (const std::uint32_t i : items) {
            const __m256d x = _mm256_sub_pd(_mm256_cvtps_pd(threeFloats(points[i].data())), centre);
            first = _mm256_add_pd(first, x);
            const __m256d xxxy = _mm256_permute4x64_pd(x, 0b01'00'00'00);
            const __m256d xyzy = _mm256_permute4x64_pd(x, 0b01'10'01'00);
            second = _mm256_add_pd(second, _mm256_mul_pd(xxxy, xyzy));
            const __m128d z = _mm_permute_pd(_mm256_extractf128_pd(x, 1), 0);
            const __m128d yz = _mm_shuffle_pd(_mm256_castpd256_pd128(x), z, 0b01);
            rest = _mm_add_pd(rest, _mm_mul_pd(yz, z));
        }
        _mm256_store_pd(sums.first.data(), first);
        _mm256_store_pd(sums.second.data(), second);
        _mm_store_pd(sums.rest.data(), rest);
    }
};

struct CellInput {
    std::span<const CellMoments> cells;
    std::size_t size() const { return cells.size(); }
    void keys(const VoxelGrid& grid, std::size_t begin, std::size_t end, std::uint64_t* keys) const {
        for (std::size_t i = begin; i < end; ++i)
            keys[i] = grid.key(cells[i].mean[0], cells[i].mean[1], cells[i].mean[2]);
    }
    void addTo(Sums& sums, const VoxelGrid& grid, std::span<const std::uint32_t> items) const {
        for (const std::uint32_t i : items) add(sums, cells[i], grid);
    }
    static void add(Sums& sums, const CellMoments& cell, const VoxelGrid& grid) {
        const double n = cell.count;
        const double x = cell.mean[0] - grid.centreX(sums.key), y = cell.mean[1] - grid.centreY(sums.key),
                     z = cell.mean[2] - grid.centreZ(sums.key);
        const double add[4] = {n * x, n * y, n * z, n};
        const double addSecond[4] = {cell.scatter[0] + n * x * x, cell.scatter[1] + n * x * y,
                                     cell.scatter[2] + n * x * z, cell.scatter[3] + n * y * y};
        for (std::size_t k = 0; k < 4; ++k) {
            sums.first[k] += add[k];
            sums.second[k] += addSecond[k];
        }
        sums.rest[0] += cell.scatter[4] + n * y * z;
        sums.rest[1] += cell.scatter[5] + n * z * z;
    }
};

CellMoments finished(const Sums& sums, const VoxelGrid& grid) {
    const __m256d first = _mm256_load_pd(sums.first.data());
    const double n = sums.first[3];
    const __m256d mean = _mm256_mul_pd(first, _mm256_set1_pd(1 / n));
    const __m256d centre =
        _mm256_setr_pd(grid.centreX(sums.key), grid.centreY(sums.key), grid.centreZ(sums.key), 0);
    // As in PointInput::addTo: xx xy xz yy, then yz zz.
    const __m256d second = _mm256_sub_pd(_mm256_load_pd(sums.second.data()),
                                         _mm256_mul_pd(_mm256_permute4x64_pd(mean, 0b01'00'00'00),
                                                       _mm256_permute4x64_pd(first, 0b01'10'01'00)));
    const double z = sums.first[2] / n;
    CellMoments cell;
    cell.key = sums.key;
    cell.count = static_cast<std::uint32_t>(n);
    alignas(16) std::array<float, 4> four;
    _mm_store_ps(four.data(), _mm256_cvtpd_ps(_mm256_add_pd(centre, mean)));
    cell.mean = {four[0], four[1], four[2]};
    _mm_store_ps(four.data(), _mm256_cvtpd_ps(second));
    cell.scatter = {four[0],
                    four[1],
                    four[2],
                    four[3],
                    static_cast<float>(sums.rest[0] - sums.first[1] * z),
                    static_cast<float>(sums.rest[1] - sums.first[2] * z)};
    return cell;
}

/// Open addressing from key to the place in a growing list of at most `most` keys.
class KeyIndex {
  public:
    explicit KeyIndex(std::size_t most) : slots_(std::bit_ceil(2 * most + 2), 0), mask_(slots_.size() - 1) {}
    std::uint32_t placeOf(std::uint64_t key) {
        std::size_t slot = VoxelGrid::hash(key) & mask_;
        for (; slots_[slot] != 0; slot = (slot + 1) & mask_)
            if (keys_[slots_[slot] - 1] == key) return slots_[slot] - 1;
        keys_.push_back(key);
        slots_[slot] = static_cast<std::uint32_t>(keys_.size());
        return slots_[slot] - 1;
    }
    const std::vector<std::uint64_t>& keys() const { return keys_; }

  private:
    std::vector<std::uint32_t> slots_;  // place + 1; 0: free
    std::vector<std::uint64_t> keys_;
    std::size_t mask_;
};

/// A stretch of items in one cell.
struct Run {
    std::uint32_t place;
    std::uint32_t end;
};

/// The cells of some items, in the order of their first item.
template <class Input, class KeyAt>
std::vector<CellMoments> gatherBucket(const Input& input, const VoxelGrid& grid,
                                      std::span<const std::uint32_t> items, const KeyAt& keyAt) {
    KeyIndex index(items.size());
    std::vector<Run> runs;
    runs.reserve(items.size());
    // Neighbours in a scan mostly share their cell.
    for (std::uint32_t from = 0, to = 0; from < items.size(); from = to) {
        const std::uint64_t key = keyAt(items[from]);
        while (to < items.size() && keyAt(items[to]) == key) ++to;
        runs.push_back({index.placeOf(key), to});
    }
    std::vector<Sums> sums(index.keys().size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].key = index.keys()[i];
    std::uint32_t begin = 0;
    for (const Run& run : runs) {
        input.addTo(sums[run.place], grid, items.subspan(begin, run.end - begin));
        begin = run.end;
    }
    std::vector<CellMoments> cells(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) cells[i] = finished(sums[i], grid);
    return cells;
}

/// Items are first sorted (counting sort, stable) into buckets by the block of space that holds their cell;
/// then each bucket is gathered on its own, in the items' order, so threads do not change the sums. Cells of
/// a block, and of each smaller cube of 2^n cells, stand together.
template <class Input>
std::vector<CellMoments> gather(const Input& input, const VoxelGrid& grid) {
    const std::size_t count = input.size();
    const std::size_t buckets = count < 2 * kGrain ? 1 : count < 32 * kGrain ? 32 : 256;
    const std::size_t chunks = (count + kGrain - 1) / kGrain;
    const auto bucketOf = [&](std::uint64_t key) {
        return VoxelGrid::hash(VoxelGrid::block(key, kBlockBits)) & (buckets - 1);
    };
    std::vector<std::uint64_t> keys(count);
    std::vector<std::uint32_t> places(chunks * buckets, 0);
    parallelChunks(count, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        input.keys(grid, begin, end, keys.data());
        for (std::size_t i = begin; i < end; ++i)
            if (keys[i] != VoxelGrid::kNoKey) ++places[bucketOf(keys[i]) * chunks + chunk];
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
                [&](std::uint32_t item) { return keys[item]; });
    });
    if (buckets == 1) return std::move(parts.front());
    std::size_t found = 0;
    for (const auto& part : parts) found += part.size();
    std::vector<CellMoments> cells;
    cells.reserve(found);
    for (const auto& part : parts) cells.insert(cells.end(), part.begin(), part.end());
    return cells;
}

/// The cells of a grid of twice the size, both without shift, in the order of their first part.
std::vector<CellMoments> gatherOctets(std::span<const CellMoments> cells, const VoxelGrid& grid) {
    KeyIndex index(cells.size());
    std::vector<std::uint32_t> places(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) places[i] = index.placeOf(VoxelGrid::parent(cells[i].key));
    std::vector<Sums> sums(index.keys().size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].key = index.keys()[i];
    for (std::size_t i = 0; i < cells.size(); ++i) CellInput::add(sums[places[i]], cells[i], grid);
    std::vector<CellMoments> octets(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) octets[i] = finished(sums[i], grid);
    return octets;
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

std::vector<std::vector<CellMoments>> gatherStages(std::span<const Eigen::Vector3f> points, double size,
                                                   double coarsest) {
    std::vector<std::vector<CellMoments>> stages{gatherPoints(points, VoxelGrid(size))};
    for (; 2 * size <= coarsest * (1 + 1e-9); size *= 2)
        stages.push_back(gatherOctets(stages.back(), VoxelGrid(2 * size)));
    return stages;
}

}  // namespace vestige
