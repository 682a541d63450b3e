#pragma once

#include <array>
#include <cstdint>

#include "core/io/formats/laz/RangeDecoder.h"

namespace vestige::laz {

/// Integers of `Bits` bits as corrections of predicted ones: the number of the correction's bits is modelled
/// for each of `Contexts` contexts, its upper eight bits for each number of bits; the others are plain.
template <unsigned Bits, unsigned Contexts>
class IntegerDecoder {
  public:
    IntegerDecoder() {
        sizes_.fill(SymbolModel<48>(Bits + 1));
        for (unsigned size = 1; size <= kModelled; ++size)
            upper_[size - 1] = SymbolModel<256>(1U << (size < 8 ? size : 8));
    }
    void restart() {
        for (auto& model : sizes_) model.restart();
        for (auto& model : upper_) model.restart();
        one_.restart();
        size_ = 0;
    }
    /// How many bits the last correction had.
    unsigned size() const { return size_; }
    /// `predicted` corrected, of which `Bits` bits count. `context` is below `Contexts`.
    [[gnu::always_inline]] std::uint32_t decode(RangeDecoder& code, std::uint32_t predicted,
                                                unsigned context) {
        size_ = code.symbol(sizes_[context]);
        return predicted + correction(code);
    }

  private:
    static constexpr unsigned kModelled = Bits < 32 ? Bits : 31;

    [[gnu::always_inline]] std::uint32_t correction(RangeDecoder& code) {
        if (size_ == 0) return code.bit(one_) ? 1U : 0U;
        if (size_ > kModelled) return 0x80000000U;
        std::uint32_t number = code.symbol(upper_[size_ - 1]);
        if (size_ > 8) number = number << (size_ - 8) | code.bits(size_ - 8);
        // The lower half are the negative corrections, and none of them is 0 or 1.
        const bool positive =
            static_cast<std::int32_t>(number) >= static_cast<std::int32_t>(1U << (size_ - 1));
        return positive ? number + 1 : number - ((1U << size_) - 1);
    }

    unsigned size_ = 0;
    std::array<SymbolModel<48>, Contexts> sizes_;
    std::array<SymbolModel<256>, kModelled> upper_;
    BitModel one_;
};

}  // namespace vestige::laz
