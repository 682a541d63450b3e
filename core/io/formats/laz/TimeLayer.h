#pragma once

#include <array>
#include <cstdint>

#include "core/io/formats/laz/IntegerDecoder.h"

namespace vestige::laz {

/// The layer of GPS times as one scanner channel has it. The bits of the doubles are taken as integers, which
/// up to four interleaved sequences foretell by multiples of their last differences.
class TimeChannel {
  public:
    /// `time`: the bits of a double.
    void begin(std::uint64_t time);
    std::uint64_t time() const { return time_; }
    /// The time of a point that has another than the last one.
    void next(RangeDecoder& code);

  private:
    struct Sequence {
        std::uint64_t time = 0;
        std::uint32_t difference = 0;
        int extremes = 0;  ///< times in a row that the difference was no multiple of the last
    };

    /// Whether the time was read; else the sequence is another one now.
    bool readAfterNone(RangeDecoder& code);
    bool readAfterDifference(RangeDecoder& code);
    void readWhole(RangeDecoder& code);
    void addDifference(std::uint32_t difference, bool extreme);

    std::uint64_t time_ = 0;
    std::array<Sequence, 4> sequences_;
    unsigned current_ = 0;
    unsigned newest_ = 0;
    SymbolModel<515> multiples_;
    SymbolModel<16> firsts_{5};
    IntegerDecoder<32, 9> decoder_;
};

}  // namespace vestige::laz
