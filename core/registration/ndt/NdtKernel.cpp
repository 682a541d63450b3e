#include "core/registration/ndt/NdtKernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/registration/ndt/Lanes.h"

namespace vestige {
namespace {

constexpr std::size_t kLanes = 8;
constexpr std::size_t kBlock = 256;
constexpr float kOutside = 1e12F;

const NormalCell kNoCell{0, {}, {}, 0, 1, 0, 0};

struct PoseLanes {
    Lanes r[3][3];
    Lanes t[3];

    explicit PoseLanes(const Pose& pose) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) r[i][j] = Lanes::of(static_cast<float>(pose.linear()(i, j)));
            t[i] = Lanes::of(static_cast<float>(pose.translation()[i]));
        }
    }
    Lanes turned(int i, Lanes x, Lanes y, Lanes z) const {
        return fma(r[i][0], x, fma(r[i][1], y, r[i][2] * z));
    }
};

/// Finds the cells of eight points at once.
class CellLookup {
  public:
    explicit CellLookup(std::span<const NormalDistributions* const> levels) : levels_(levels) {}

    /// Fills `cells`; kNoCell where no level has one. Returns how many have.
    unsigned operator()(Lanes x, Lanes y, Lanes z, const NormalCell* (&cells)[kLanes]) const {
        unsigned missing = (1U << kLanes) - 1;
        for (const NormalDistributions* level : levels_) {
            missing = findAt(*level, x, y, z, missing, cells);
            if (missing == 0) return kLanes;
        }
        for (unsigned lanes = missing; lanes != 0; lanes &= lanes - 1)
            cells[std::countr_zero(lanes)] = &kNoCell;
        return kLanes - static_cast<unsigned>(std::popcount(missing));
    }

    /// The same for points that were looked up before.
    unsigned operator()(Lanes x, Lanes y, Lanes z, FoundCells& found) const {
        const Index finest(levels_.front()->grid(), x, y, z), shifted(levels_.back()->grid(), x, y, z);
        const unsigned same = finest.sameAs(found.low.data(), found.high.data()) &
                              shifted.sameAs(found.shiftedLow.data(), found.shiftedHigh.data());
        unsigned missing = ~same & ((1U << kLanes) - 1);
        if (missing != 0) {
            finest.store(found.low.data(), found.high.data());
            shifted.store(found.shiftedLow.data(), found.shiftedHigh.data());
            auto& cells = reinterpret_cast<const NormalCell*(&)[kLanes]>(*found.cells.data());
            for (const NormalDistributions* level : levels_) {
                missing = findAt(*level, x, y, z, missing, cells);
                if (missing == 0) break;
            }
            for (unsigned lanes = missing; lanes != 0; lanes &= lanes - 1)
                cells[std::countr_zero(lanes)] = &kNoCell;
        }
        unsigned inside = 0;
        for (const NormalCell* cell : found.cells) inside += static_cast<unsigned>(cell != &kNoCell);
        return inside;
    }

  private:
    /// The voxels of eight points, their keys in two halves.
    struct Index {
        IntLanes low, high;

        Index(const VoxelGrid& grid, Lanes x, Lanes y, Lanes z) {
            const Lanes scale = Lanes::of(static_cast<float>(grid.perMetre()));
            const Lanes shift = Lanes::of(static_cast<float>(grid.shift() * grid.perMetre()));
            const IntLanes half = IntLanes::of(static_cast<int>(VoxelGrid::kHalf));
            // What lies outside the grid is clamped to a border where no cell is.
            const Lanes limit = Lanes::of(static_cast<float>(VoxelGrid::kHalf - 1));
            const auto index = [&](Lanes a) {
                return floorOf(max(min(fma(a, scale, shift), limit), -limit)) + half;
            };
            const IntLanes i = index(x), j = index(y), k = index(z);
            low = i | j.left(21);
            high = j.right(11) | k.left(10);
        }
        void store(std::uint32_t* toLow, std::uint32_t* toHigh) const {
            _mm256_store_si256(reinterpret_cast<__m256i*>(toLow), low.v);
            _mm256_store_si256(reinterpret_cast<__m256i*>(toHigh), high.v);
        }
        unsigned sameAs(const std::uint32_t* otherLow, const std::uint32_t* otherHigh) const {
            const auto equal = [](IntLanes a, const std::uint32_t* b) {
                return _mm256_cmpeq_epi32(a.v, _mm256_load_si256(reinterpret_cast<const __m256i*>(b)));
            };
            const __m256i both = _mm256_and_si256(equal(low, otherLow), equal(high, otherHigh));
            return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(both)));
        }
    };

    static unsigned findAt(const NormalDistributions& level, Lanes x, Lanes y, Lanes z, unsigned wanted,
                           const NormalCell* (&cells)[kLanes]) {
        const auto [low, high] = Index(level.grid(), x, y, z);
        const auto constant = [](std::uint32_t value) { return IntLanes::of(static_cast<int>(value)); };
        IntLanes h = low * constant(VoxelGrid::kHashLow) + high * constant(VoxelGrid::kHashHigh);
        h = (h ^ h.right(16)) * constant(VoxelGrid::kHashFirst);
        h = (h ^ h.right(15)) * constant(VoxelGrid::kHashSecond);
        h = (h ^ h.right(16)) & constant(level.mask());
        alignas(32) std::uint32_t slots[kLanes];
        alignas(32) std::uint32_t lows[kLanes];
        alignas(32) std::uint32_t highs[kLanes];
        _mm256_store_si256(reinterpret_cast<__m256i*>(slots), h.v);
        _mm256_store_si256(reinterpret_cast<__m256i*>(lows), low.v);
        _mm256_store_si256(reinterpret_cast<__m256i*>(highs), high.v);
        const std::uint64_t* keys = level.keys();
        unsigned missing = 0;
        for (; wanted != 0; wanted &= wanted - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(wanted));
            const std::uint64_t key = lows[lane] | static_cast<std::uint64_t>(highs[lane]) << 32;
            std::uint32_t slot = slots[lane];
            while (keys[slot] != key && keys[slot] != VoxelGrid::kNoKey) slot = (slot + 1) & level.mask();
            cells[lane] = level.table() + slot;
            missing |= static_cast<unsigned>(keys[slot] != key) << lane;
        }
        return missing;
    }

    std::span<const NormalDistributions* const> levels_;
};

struct CellLanes {
    Lanes mean[3];
    Lanes xx, xy, xz, yy, yz, zz;
    Lanes depth, steepness;

    explicit CellLanes(const NormalCell* const* cells) {
        Lanes rows[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i)
            rows[i] = Lanes::load(reinterpret_cast<const float*>(cells[i]));
        transpose(rows);
        mean[0] = rows[2];
        mean[1] = rows[3];
        mean[2] = rows[4];
        xx = rows[5];
        xy = rows[6];
        xz = rows[7];
        for (std::size_t i = 0; i < kLanes; ++i)
            rows[i] = Lanes::load(reinterpret_cast<const float*>(cells[i]) + kLanes);
        transpose(rows);
        yy = rows[0];
        yz = rows[1];
        zz = rows[2];
        depth = rows[3];
        steepness = rows[4];
    }
};
static_assert(sizeof(NormalCell) == 64 && offsetof(NormalCell, mean) == 8 &&
              offsetof(NormalCell, information) == 20 && offsetof(NormalCell, depth) == 44 &&
              offsetof(NormalCell, steepness) == 48);

/// e = x - mean, u = C^-1 e and s = d1 exp(-d2 e.u / 2) of eight points.
struct Scored {
    Lanes ux, uy, uz, q, s;

    Scored(const CellLanes& cell, Lanes x, Lanes y, Lanes z) {
        const Lanes ex = x - cell.mean[0], ey = y - cell.mean[1], ez = z - cell.mean[2];
        ux = fma(cell.xx, ex, fma(cell.xy, ey, cell.xz * ez));
        uy = fma(cell.xy, ex, fma(cell.yy, ey, cell.yz * ez));
        uz = fma(cell.xz, ex, fma(cell.yz, ey, cell.zz * ez));
        q = fma(ex, ux, fma(ey, uy, ez * uz));
        s = cell.depth * exponential(Lanes::of(-0.5F) * cell.steepness * q);
    }
};

double sumOf(Lanes lanes) {
    alignas(32) float values[kLanes];
    lanes.store(values);
    double sum = 0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum;
}

/// Sums of a block: the score, the gradient, the Hessian.
struct BlockSums {
    Lanes score = Lanes::zero();
    Lanes gradient[6];
    Lanes hessian[21];

    BlockSums() {
        for (Lanes& sum : gradient) sum = Lanes::zero();
        for (Lanes& sum : hessian) sum = Lanes::zero();
    }
    void addTo(NdtSums& sums) const {
        sums.score += sumOf(score);
        for (std::size_t i = 0; i < 6; ++i) sums.gradient[i] += sumOf(gradient[i]);
        for (std::size_t i = 0; i < 21; ++i) sums.hessian[i] += sumOf(hessian[i]);
    }

    /// `y`: R times the centred source points, over the radius.
    ///
    /// With J = [I | -[y]x] the derivatives of s are -d2 s J'u and k (J' C^-1 J + D - d2 J'u u'J), k = -d2 s,
    /// where D, the second derivative of exp(w) y against u, is ((u y' + y u') / 2 - (u.y) I) / radius in the
    /// block of the rotation.
    void add(const CellLanes& cell, const Scored& point, Lanes yx, Lanes yy, Lanes yz, Lanes perRadius) {
        const Lanes ux = point.ux, uy = point.uy, uz = point.uz;
        score = score + point.s;
        const Lanes k = -(cell.steepness * point.s);
        const Lanes a[6] = {ux, uy, uz, fms(yy, uz, yz * uy), fms(yz, ux, yx * uz), fms(yx, uy, yy * ux)};
        for (int i = 0; i < 6; ++i) gradient[i] = fma(k, a[i], gradient[i]);

        // M = C^-1 (-[y]x), rows of the translation, columns of the rotation.
        const Lanes m00 = fms(cell.xz, yy, cell.xy * yz), m01 = fms(cell.xx, yz, cell.xz * yx),
                    m02 = fms(cell.xy, yx, cell.xx * yy);
        const Lanes m10 = fms(cell.yz, yy, cell.yy * yz), m11 = fms(cell.xy, yz, cell.yz * yx),
                    m12 = fms(cell.yy, yx, cell.xy * yy);
        const Lanes m20 = fms(cell.zz, yy, cell.yz * yz), m21 = fms(cell.xz, yz, cell.zz * yx),
                    m22 = fms(cell.yz, yx, cell.xz * yy);
        // [y]x M, its upper triangle, plus D.
        const Lanes half = Lanes::of(0.5F) * perRadius;
        const Lanes vx = half * ux, vy = half * uy, vz = half * uz;
        const Lanes xx = vx * yx, yyy = vy * yy, zz = vz * yz;
        const Lanes dot = Lanes::of(2) * (xx + yyy + zz);
        const Lanes r00 = fma(yy, m20, fnma(yz, m10, xx + xx - dot));
        const Lanes r01 = fma(yy, m21, fnma(yz, m11, fma(vx, yy, vy * yx)));
        const Lanes r02 = fma(yy, m22, fnma(yz, m12, fma(vx, yz, vz * yx)));
        const Lanes r11 = fma(yz, m01, fnma(yx, m21, yyy + yyy - dot));
        const Lanes r12 = fma(yz, m02, fnma(yx, m22, fma(vy, yz, vz * yy)));
        const Lanes r22 = fma(yx, m12, fnma(yy, m02, zz + zz - dot));
        const Lanes base[21] = {cell.xx, cell.xy, cell.xz, m00, m01, m02, cell.yy, cell.yz, m10, m11, m12,
                                cell.zz, m20,     m21,     m22, r00, r01, r02,     r11,     r12, r22};
        int entry = 0;
        for (int i = 0; i < 6; ++i) {
            const Lanes di = cell.steepness * a[i];
            for (int j = i; j < 6; ++j, ++entry)
                hessian[entry] = fma(k, fnma(di, a[j], base[entry]), hessian[entry]);
        }
    }
};

}  // namespace

PointLanes::PointLanes(std::span<const Eigen::Vector3f> points) : count(points.size()) {
    const std::size_t padded = (count + kLanes - 1) / kLanes * kLanes;
    for (std::vector<float>* axis : {&x, &y, &z}) axis->assign(padded, kOutside);
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = points[i].x();
        y[i] = points[i].y();
        z[i] = points[i].z();
    }
}

FoundCells::FoundCells() {
    for (auto* index : {&low, &high, &shiftedLow, &shiftedHigh}) index->fill(kNowhere);
    cells.fill(&kNoCell);
}

bool canRemember(std::span<const NormalDistributions* const> levels) {
    const VoxelGrid& finest = levels.front()->grid();
    if (finest.shift() != 0) return false;
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const VoxelGrid& grid = levels[i]->grid();
        if (i + 1 == levels.size() && grid.shift() != 0) continue;
        int power = 0;
        if (grid.shift() != 0 || std::frexp(grid.size() / finest.size(), &power) != 0.5) return false;
    }
    return true;
}

NdtSums& NdtSums::operator+=(const NdtSums& other) {
    score += other.score;
    inside += other.inside;
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] += other.gradient[i];
    for (std::size_t i = 0; i < hessian.size(); ++i) hessian[i] += other.hessian[i];
    return *this;
}

NdtSums sumNdt(std::span<const NormalDistributions* const> levels, const PointLanes& points,
               std::size_t begin, std::size_t end, const Pose& pose, double radius,
               std::span<FoundCells> found) {
    const PoseLanes lanes(pose);
    const CellLookup lookup(levels);
    const Lanes perRadius = Lanes::of(static_cast<float>(1 / radius));
    NdtSums sums;
    for (std::size_t from = begin; from < end; from += kBlock) {
        BlockSums block;
        const std::size_t to = std::min(from + kBlock, end);
        for (std::size_t i = from; i < to; i += kLanes) {
            const Lanes px = Lanes::load(&points.x[i]), py = Lanes::load(&points.y[i]),
                        pz = Lanes::load(&points.z[i]);
            const Lanes yx = lanes.turned(0, px, py, pz), yy = lanes.turned(1, px, py, pz),
                        yz = lanes.turned(2, px, py, pz);
            const Lanes x = yx + lanes.t[0], y = yy + lanes.t[1], z = yz + lanes.t[2];
            const NormalCell* looked[kLanes];
            const unsigned inside =
                found.empty() ? lookup(x, y, z, looked) : lookup(x, y, z, found[i / kLanes]);
            if (inside == 0) continue;
            sums.inside += inside;
            const CellLanes cell(found.empty() ? looked : found[i / kLanes].cells.data());
            block.add(cell, Scored(cell, x, y, z), yx * perRadius, yy * perRadius, yz * perRadius, perRadius);
        }
        block.addTo(sums);
    }
    return sums;
}

double sumNdtScore(std::span<const NormalDistributions* const> levels, const PointLanes& points,
                   std::size_t begin, std::size_t end, const Pose& pose) {
    const PoseLanes lanes(pose);
    const CellLookup lookup(levels);
    double sum = 0;
    for (std::size_t from = begin; from < end; from += kBlock) {
        Lanes block = Lanes::zero();
        const std::size_t to = std::min(from + kBlock, end);
        for (std::size_t i = from; i < to; i += kLanes) {
            const Lanes px = Lanes::load(&points.x[i]), py = Lanes::load(&points.y[i]),
                        pz = Lanes::load(&points.z[i]);
            const Lanes x = lanes.turned(0, px, py, pz) + lanes.t[0];
            const Lanes y = lanes.turned(1, px, py, pz) + lanes.t[1];
            const Lanes z = lanes.turned(2, px, py, pz) + lanes.t[2];
            const NormalCell* cells[kLanes];
            if (lookup(x, y, z, cells) == 0) continue;
            block = block + Scored(CellLanes(cells), x, y, z).s;
        }
        sum += sumOf(block);
    }
    return sum;
}

void surfaceDistancesOf(std::span<const NormalDistributions* const> levels, const PointLanes& points,
                        std::size_t begin, std::size_t end, const Pose& pose, float* distances) {
    const PoseLanes lanes(pose);
    const CellLookup lookup(levels);
    const Lanes infinite = Lanes::of(std::numeric_limits<float>::infinity());
    for (std::size_t i = begin; i < end; i += kLanes) {
        const Lanes px = Lanes::load(&points.x[i]), py = Lanes::load(&points.y[i]),
                    pz = Lanes::load(&points.z[i]);
        const Lanes x = lanes.turned(0, px, py, pz) + lanes.t[0];
        const Lanes y = lanes.turned(1, px, py, pz) + lanes.t[1];
        const Lanes z = lanes.turned(2, px, py, pz) + lanes.t[2];
        const NormalCell* cells[kLanes];
        if (lookup(x, y, z, cells) == 0) {
            infinite.store(distances + i);
            continue;
        }
        const CellLanes cell(cells);
        const Lanes trace = cell.xx + cell.yy + cell.zz;
        const Lanes distance = sqrt(max(Lanes::zero(), Scored(cell, x, y, z).q) / trace);
        select(below(Lanes::zero(), trace), distance, infinite).store(distances + i);
    }
}

}  // namespace vestige
