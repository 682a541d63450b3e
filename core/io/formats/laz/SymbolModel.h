#pragma once

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace vestige::laz {

/// Probabilities have 15 bits.
inline constexpr unsigned kProbabilityBits = 15;
inline constexpr std::uint32_t kMostCounted = 1U << kProbabilityBits;

/// Beginnings of ranges are kept less 2^15: sixteen signed numbers are compared at once, and the places of a
/// code, which are a little more than 15 bits, fit. Above all of them:
inline constexpr std::int16_t kAbove = 0x7fff;
inline constexpr std::uint32_t kBias = 0x8000;

/// Twice how many of 16 ascending numbers are not above `place`.
[[gnu::always_inline]] inline unsigned twiceCountUpTo(const std::int16_t* ascending, __m256i place) {
    const __m256i above =
        _mm256_cmpgt_epi16(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(ascending)), place);
    return static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(_mm256_movemask_epi8(above))));
}

/// An adaptive model of up to `Capacity` symbols after A. Said, "Introduction to Arithmetic Coding - Theory
/// and Practice" (HP Labs 2004), with the counts, halvings and update cycles of LASzip. Every symbol always
/// has a part of the range. Where a code's place in the range leads to is found by comparing sixteen symbols
/// at once, which has no branches to guess wrong.
template <unsigned Capacity>
class SymbolModel {
  public:
    explicit SymbolModel(unsigned symbols = Capacity) : symbols_(static_cast<std::uint16_t>(symbols)) {}

    unsigned last() const { return symbols_ - 1U; }
    /// Forgets what was learned, when it is used next.
    void restart() { cycle_ = 0; }
    [[gnu::always_inline]] void prepare() {
        if (cycle_ == 0) [[unlikely]]
            begin();
    }
    /// The symbol in whose part of the range `place` lies. RangeDecoder asks for places below 2^15 + 64.
    [[gnu::always_inline]] unsigned find(std::uint32_t place) const {
        const __m256i wanted = _mm256_set1_epi16(static_cast<short>(place - kBias));
        if constexpr (kDirect) {
            unsigned twice = 0;
            for (unsigned at = 0; at < kSize; at += 16) twice += twiceCountUpTo(from_.data() + at, wanted);
            return twice / 2 - 1;
        } else {
            unsigned twice = 0;
            for (unsigned at = 0; at < kGroups; at += 16)
                twice += twiceCountUpTo(groups_.data() + at, wanted);
            const unsigned group = 8 * twice - 16;
            return group + twiceCountUpTo(from_.data() + group, wanted) / 2 - 1;
        }
    }
    /// Where the part of `symbol` begins.
    [[gnu::always_inline]] std::uint32_t from(unsigned symbol) const {
        return static_cast<std::uint32_t>(from_[symbol] + static_cast<int>(kBias));
    }
    [[gnu::always_inline]] void count(unsigned symbol) {
        ++counts_[symbol];
        if (--untilUpdate_ == 0) [[unlikely]]
            update();
    }

  private:
    static constexpr unsigned kSize = (Capacity + 15) / 16 * 16;
    static constexpr bool kDirect = kSize <= 48;
    static constexpr unsigned kGroups = kDirect ? 0 : (kSize / 16 + 15) / 16 * 16;

    [[gnu::noinline]] void begin() {
        from_.fill(kAbove);
        groups_.fill(kAbove);
        std::fill_n(counts_.begin(), symbols_, std::uint16_t{1});
        total_ = 0;
        cycle_ = symbols_;
        update();
        cycle_ = (symbols_ + 6U) >> 1;
        untilUpdate_ = cycle_;
    }
    [[gnu::noinline]] void update() {
        total_ += cycle_;
        if (total_ > kMostCounted) {
            total_ = 0;
            for (unsigned symbol = 0; symbol < symbols_; ++symbol) {
                counts_[symbol] = static_cast<std::uint16_t>((counts_[symbol] + 1U) >> 1);
                total_ += counts_[symbol];
            }
        }
        const std::uint32_t scale = 0x80000000U / total_;
        std::uint32_t sum = 0;
        for (unsigned symbol = 0; symbol < symbols_; ++symbol) {
            from_[symbol] = static_cast<std::int16_t>(((scale * sum) >> (31 - kProbabilityBits)) - kBias);
            sum += counts_[symbol];
        }
        if constexpr (!kDirect)
            for (unsigned group = 0; group < kSize / 16; ++group) groups_[group] = from_[16 * group];
        cycle_ = std::min((5 * cycle_) >> 2, (symbols_ + 6U) << 3);
        untilUpdate_ = cycle_;
    }

    std::uint16_t symbols_;
    std::uint32_t cycle_ = 0;  ///< 0: nothing is prepared yet
    std::uint32_t untilUpdate_ = 0;
    std::uint32_t total_ = 0;
    std::array<std::int16_t, kSize> from_;
    std::array<std::int16_t, kGroups> groups_;  ///< the beginning of every sixteenth symbol
    std::array<std::uint16_t, kSize> counts_;
};

}  // namespace vestige::laz
