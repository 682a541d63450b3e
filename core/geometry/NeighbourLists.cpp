#include "core/geometry/NeighbourLists.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>

#include "core/base/Parallel.h"
#include "core/geometry/LeafScan.h"

namespace vestige {
namespace {

constexpr std::size_t kLeaf = NeighbourIndex::kLeaf;
constexpr std::size_t kLanes = 8;
constexpr std::size_t kGroups = kLeaf / kLanes;
constexpr std::size_t kGrain = 64;
/// Up to here a list is gone through to its end.
constexpr std::size_t kFewRows = 32;

using Row = std::array<float, kLanes>;
struct alignas(32) AlignedRow {
    Row values;
};
static_assert(sizeof(AlignedRow) == sizeof(Row));

struct Candidate {
    float squared;
    std::uint32_t leaf;
};

/// Eight points of a leaf and, lane by lane, the ascending squared distances to the nearest found so far.
class LaneGroup {
  public:
    /// `rows`: as many as distances are wanted.
    void begin(const NeighbourIndex::Leaf& leaf, std::size_t first, std::size_t size,
               std::span<AlignedRow> rows) {
        rows_ = rows;
        farthest_ = std::numeric_limits<float>::infinity();
        for (AlignedRow& row : rows_) row.values.fill(std::numeric_limits<float>::infinity());
        box_ = {};
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            // Lanes without a point repeat the first one's work.
            const std::size_t from = first + (lane < size ? lane : 0);
            for (std::size_t axis = 0; axis < 3; ++axis) at_[axis].values[lane] = leaf.axes[axis][from];
            box_.add({leaf.axes[0][from], leaf.axes[1][from], leaf.axes[2][from]});
        }
    }

    const FloatBox& box() const { return box_; }
    std::span<const Row> rows() const { return {&rows_.front().values, rows_.size()}; }
    /// Of all lanes, the largest distance that is still to be beaten.
    float farthest() const { return farthest_; }

    void scan(const NeighbourIndex::Leaf& leaf) {
        const __m256 x = _mm256_load_ps(at_[0].values.data());
        const __m256 y = _mm256_load_ps(at_[1].values.data());
        const __m256 z = _mm256_load_ps(at_[2].values.data());
        const __m256 limit = _mm256_load_ps(rows_.back().values.data());
        std::array<AlignedRow, kLeaf> squared;
        std::uint32_t near = 0;
        // First those that are near enough to the box round the eight, many at a time.
        for (std::uint32_t places = nearBox(leaf); places != 0; places &= places - 1) {
            const auto place = static_cast<std::size_t>(std::countr_zero(places));
            const __m256 dx = _mm256_sub_ps(_mm256_broadcast_ss(&leaf.axes[0][place]), x);
            const __m256 dy = _mm256_sub_ps(_mm256_broadcast_ss(&leaf.axes[1][place]), y);
            const __m256 dz = _mm256_sub_ps(_mm256_broadcast_ss(&leaf.axes[2][place]), z);
            const __m256 level = _mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy));
            const __m256 distance = _mm256_add_ps(level, _mm256_mul_ps(dz, dz));
            _mm256_store_ps(squared[place].values.data(), distance);
            const int lanes = _mm256_movemask_ps(_mm256_cmp_ps(distance, limit, _CMP_LT_OQ));
            near |= static_cast<std::uint32_t>(lanes != 0) << place;
        }
        if (near == 0) return;
        for (; near != 0; near &= near - 1)
            insert(_mm256_load_ps(squared[static_cast<std::size_t>(std::countr_zero(near))].values.data()));
        __m256 last = _mm256_load_ps(rows_.back().values.data());
        last = _mm256_max_ps(last, _mm256_permute2f128_ps(last, last, 1));
        last = _mm256_max_ps(last, _mm256_permute_ps(last, 0b01001110));
        farthest_ =
            _mm_cvtss_f32(_mm256_castps256_ps128(_mm256_max_ps(last, _mm256_permute_ps(last, 0b10110001))));
    }

  private:
    /// The places of the leaf's points whose distance from the box is less than what is to be beaten: a bit
    /// each.
    std::uint32_t nearBox(const NeighbourIndex::Leaf& leaf) const {
        std::uint32_t places = 0;
        for (std::size_t at = 0; at < kLeaf; at += kLanes) {
            __m256 sum{};
#pragma GCC unroll 3
            for (int axis = 0; axis < 3; ++axis) {
                const __m256 value = _mm256_load_ps(leaf.axes[static_cast<std::size_t>(axis)].data() + at);
                const __m256 below = _mm256_sub_ps(_mm256_set1_ps(box_.min[axis]), value);
                const __m256 above = _mm256_sub_ps(value, _mm256_set1_ps(box_.max[axis]));
                const __m256 gap = _mm256_max_ps(_mm256_max_ps(below, above), _mm256_setzero_ps());
                sum = _mm256_add_ps(sum, _mm256_mul_ps(gap, gap));
            }
            const __m256 nearer = _mm256_cmp_ps(sum, _mm256_set1_ps(farthest_), _CMP_LT_OQ);
            places |= static_cast<std::uint32_t>(_mm256_movemask_ps(nearer)) << at;
        }
        return places;
    }

    /// Each row becomes the middle one of its own, the one below and the new value: no row waits for another,
    /// and stopping early would cost more in branches than the rows do.
    void insert(__m256 value) {
        float* const rows = rows_.front().values.data();
        std::size_t row = rows_.size() - 1;
        __m256 here = _mm256_load_ps(rows + row * kLanes);
        for (; row >= kFewRows; row -= 4) {
            here = raise(rows + row * kLanes, here, value);
            // Long lists are mostly left alone.
            if (_mm256_movemask_ps(_mm256_cmp_ps(value, here, _CMP_LT_OQ)) == 0) return;
        }
        for (; row >= 4; row -= 4) here = raise(rows + row * kLanes, here, value);
        for (; row > 0; --row) {
            const __m256 below = _mm256_load_ps(rows + (row - 1) * kLanes);
            _mm256_store_ps(rows + row * kLanes, _mm256_max_ps(below, _mm256_min_ps(here, value)));
            here = below;
        }
        _mm256_store_ps(rows, _mm256_min_ps(here, value));
    }

    /// Four rows, from `top` (which holds `here`) down; the row below them.
    static __m256 raise(float* top, __m256 here, __m256 value) {
        const __m256 a = _mm256_load_ps(top - kLanes);
        const __m256 b = _mm256_load_ps(top - 2 * kLanes);
        const __m256 c = _mm256_load_ps(top - 3 * kLanes);
        const __m256 d = _mm256_load_ps(top - 4 * kLanes);
        _mm256_store_ps(top, _mm256_max_ps(a, _mm256_min_ps(here, value)));
        _mm256_store_ps(top - kLanes, _mm256_max_ps(b, _mm256_min_ps(a, value)));
        _mm256_store_ps(top - 2 * kLanes, _mm256_max_ps(c, _mm256_min_ps(b, value)));
        _mm256_store_ps(top - 3 * kLanes, _mm256_max_ps(d, _mm256_min_ps(c, value)));
        return d;
    }

    std::array<AlignedRow, 3> at_;
    FloatBox box_;
    std::span<AlignedRow> rows_;
    float farthest_ = 0;
};

/// As BoxTree has it.
inline float squaredDistance(const FloatBox& a, const FloatBox& b) {
    // min.x min.y min.z max.x | min.z max.x max.y max.z
    static_assert(sizeof(FloatBox) == 6 * sizeof(float));
    const auto minOf = [](const FloatBox& box) { return _mm_loadu_ps(box.min.data()); };
    const auto maxOf = [](const FloatBox& box) {
        return _mm_permute_ps(_mm_loadu_ps(box.min.data() + 2), 0b11111001);
    };
    const __m128 below = _mm_sub_ps(minOf(a), maxOf(b));
    const __m128 above = _mm_sub_ps(minOf(b), maxOf(a));
    const __m128 gap = _mm_max_ps(_mm_max_ps(below, above), _mm_setzero_ps());
    const __m128 square = _mm_mul_ps(gap, gap);
    const __m128 level = _mm_add_ss(square, _mm_movehdup_ps(square));
    return _mm_cvtss_f32(_mm_add_ss(level, _mm_movehl_ps(square, square)));
}

/// Finds the neighbours of one leaf's points after the other.
class LeafQueries {
  public:
    LeafQueries(const NeighbourIndex& index, std::size_t count)
        : index_(index), count_(count), rows_(kGroups * count) {}

    template <class Use>
    void answer(std::size_t leaf, const Use& use) {
        const std::size_t size = index_.leafSize(leaf);
        const std::size_t groups = (size + kLanes - 1) / kLanes;
        for (std::size_t g = 0; g < groups; ++g)
            groups_[g].begin(index_.leaves()[leaf], g * kLanes, std::min(kLanes, size - g * kLanes),
                             std::span(rows_).subspan(g * count_, count_));
        // The leaves before and after along the curve until there are enough points for a first limit.
        std::size_t first = leaf;
        std::size_t last = leaf;
        while ((last - first + 1) * kLeaf < count_ + kLeaf &&
               (first > 0 || last + 1 < index_.leaves().size())) {
            first -= first > 0;
            last += last + 1 < index_.leaves().size();
        }
        for (std::size_t other = first; other <= last; ++other)
            for (std::size_t g = 0; g < groups; ++g) groups_[g].scan(index_.leaves()[other]);
        float limit = 0;
        for (std::size_t g = 0; g < groups; ++g) limit = std::max(limit, groups_[g].farthest());
        candidates_.clear();
        index_.tree().nearerThan(index_.box(leaf), limit, [&](std::uint32_t other, float squared) {
            if (other < first || other > last) candidates_.push_back({squared, other});
        });
        std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
            return a.squared != b.squared ? a.squared < b.squared : a.leaf < b.leaf;
        });
        for (std::size_t g = 0; g < groups; ++g) {
            LaneGroup& group = groups_[g];
            for (const Candidate& candidate : candidates_) {
                const float beaten = group.farthest();
                if (!(candidate.squared < beaten)) break;
                if (squaredDistance(group.box(), index_.box(candidate.leaf)) < beaten)
                    group.scan(index_.leaves()[candidate.leaf]);
            }
            const std::size_t at = leaf * kLeaf + g * kLanes;
            use(NearestDistances{index_.order().subspan(at, std::min(kLanes, size - g * kLanes)),
                                 group.rows()});
        }
    }

  private:
    const NeighbourIndex& index_;
    std::size_t count_;
    std::vector<AlignedRow> rows_;
    std::array<LaneGroup, kGroups> groups_;
    std::vector<Candidate> candidates_;
};

template <class Answer>
void forLeaves(const NeighbourIndex& index, std::size_t count, const std::function<void(std::size_t)>& done,
               const Answer& answer) {
    parallelFor(index.leaves().size(), kGrain, [&](std::size_t begin, std::size_t end) {
        LeafQueries queries(index, count);
        for (std::size_t leaf = begin; leaf < end; ++leaf) answer(queries, leaf);
        if (done) done(std::min(end * kLeaf, index.size()) - begin * kLeaf);
    });
}

}  // namespace

void forNearestDistances(const NeighbourIndex& index, std::size_t count,
                         const std::function<void(const NearestDistances&)>& use,
                         const std::function<void(std::size_t)>& done) {
    forLeaves(index, count, done, [&](LeafQueries& queries, std::size_t leaf) { queries.answer(leaf, use); });
}

void forNearest(
    const NeighbourIndex& index, std::size_t count,
    const std::function<void(std::uint32_t point, std::span<const NeighbourIndex::Neighbour>)>& use,
    const std::function<void(std::size_t)>& done) {
    forLeaves(index, count, done, [&](LeafQueries& queries, std::size_t leaf) {
        thread_local std::vector<NeighbourIndex::Neighbour> found;
        const auto& axes = index.leaves()[leaf].axes;
        std::size_t place = 0;
        queries.answer(leaf, [&](const NearestDistances& nearest) {
            for (std::size_t lane = 0; lane < nearest.points.size(); ++lane, ++place) {
                const Eigen::Vector3f centre(axes[0][place], axes[1][place], axes[2][place]);
                index.within(centre, nearest.squared.back()[lane], found);
                std::sort(found.begin(), found.end(), NeighbourIndex::nearer);
                use(nearest.points[lane], std::span(found).first(std::min(count, found.size())));
            }
        });
    });
}

}  // namespace vestige
