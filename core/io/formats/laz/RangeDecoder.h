#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/io/Bytes.h"
#include "core/io/formats/laz/BitModel.h"
#include "core/io/formats/laz/SymbolModel.h"

namespace vestige::laz {

/// Arithmetic decoder of 32 bits after A. Said (see SymbolModel) over the bytes of one layer. Whatever they
/// are, the value stays below the length of the range, which keeps every symbol within its model. Beyond the
/// end zeros are read, which `failed` tells.
class RangeDecoder {
  public:
    RangeDecoder() = default;
    explicit RangeDecoder(std::span<const std::byte> bytes)
        : next_(bytes.data()), end_(bytes.data() + bytes.size()) {
        for (int i = 0; i < 4; ++i) value_ = value_ << 8 | nextByte();
        if (value_ < length_) return;
        // No encoder writes this.
        value_ = 0;
        failed_ = true;
    }

    /// Whether the bytes were too few, or none that an encoder writes: then nothing that was read is worth
    /// anything.
    bool failed() const { return failed_; }
    void fail() { failed_ = true; }

    template <unsigned Capacity>
    [[gnu::always_inline]] unsigned symbol(SymbolModel<Capacity>& model) {
        model.prepare();
        const std::uint32_t unit = length_ >> kProbabilityBits;
        const unsigned symbol = model.find(value_ / unit);
        const std::uint32_t begin = model.from(symbol) * unit;
        const std::uint32_t end = symbol == model.last() ? length_ : model.from(symbol + 1) * unit;
        value_ -= begin;
        length_ = end - begin;
        renormalise();
        model.count(symbol);
        return symbol;
    }
    [[gnu::always_inline]] bool bit(BitModel& model) {
        const std::uint32_t split = model.probabilityOfZero() * (length_ >> BitModel::kProbabilityBits);
        const bool bit = value_ >= split;
        if (bit) {
            value_ -= split;
            length_ -= split;
        } else {
            length_ = split;
        }
        renormalise();
        model.count(bit);
        return bit;
    }
    /// `count` bits, 1 to 32, that no model foretells. A number beyond them is none that an encoder writes.
    [[gnu::always_inline]] std::uint32_t bits(unsigned count) {
        if (count <= 19) return fewBits(count);
        const std::uint32_t low = fewBits(16);
        return fewBits(count - 16) << 16 | low;
    }

  private:
    [[gnu::always_inline]] std::uint32_t fewBits(unsigned count) {
        length_ >>= count;
        const std::uint32_t number = value_ / length_;
        value_ -= number * length_;
        failed_ = failed_ || number >> count != 0;
        renormalise();
        return number;
    }
    [[gnu::always_inline]] std::uint32_t nextByte() {
        if (next_ != end_) return std::to_integer<std::uint32_t>(*next_++);
        failed_ = true;
        return 0;
    }
    /// Lengthens the range to 2^24 or more, by up to three bytes.
    [[gnu::always_inline]] void renormalise() {
        const unsigned bits = static_cast<unsigned>(std::countl_zero(length_)) & 24U;
        if (end_ - next_ >= 4) [[likely]] {
            const std::uint64_t ahead = __builtin_bswap32(load<std::uint32_t>(next_));
            value_ = static_cast<std::uint32_t>(((std::uint64_t{value_} << 32 | ahead) << bits) >> 32);
            length_ <<= bits;
            next_ += bits / 8;
            return;
        }
        for (unsigned done = 0; done < bits; done += 8) value_ = value_ << 8 | nextByte();
        length_ <<= bits;
    }

    const std::byte* next_ = nullptr;
    const std::byte* end_ = nullptr;
    std::uint32_t value_ = 0;
    std::uint32_t length_ = 0xffffffff;
    bool failed_ = false;
};

}  // namespace vestige::laz
