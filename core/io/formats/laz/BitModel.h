#pragma once

#include <algorithm>
#include <cstdint>

namespace vestige::laz {

/// The adaptive model of one bit; see SymbolModel.
class BitModel {
  public:
    static constexpr unsigned kProbabilityBits = 13;

    void restart() { *this = {}; }
    /// Of 2^13, more than 0 and less than all.
    std::uint32_t probabilityOfZero() const { return probability_; }
    void count(bool bit) {
        if (!bit) ++zeros_;
        if (--untilUpdate_ == 0) update();
    }

  private:
    void update() {
        total_ += cycle_;
        if (total_ > 1U << kProbabilityBits) {
            total_ = (total_ + 1) >> 1;
            zeros_ = (zeros_ + 1) >> 1;
            if (zeros_ == total_) ++total_;
        }
        probability_ = (zeros_ * (0x80000000U / total_)) >> (31 - kProbabilityBits);
        cycle_ = std::min<std::uint32_t>((5 * cycle_) >> 2, 64);
        untilUpdate_ = cycle_;
    }

    std::uint32_t probability_ = 1U << (kProbabilityBits - 1);
    std::uint32_t zeros_ = 1;
    std::uint32_t total_ = 2;
    std::uint32_t cycle_ = 4;
    std::uint32_t untilUpdate_ = 4;
};

}  // namespace vestige::laz
