#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/io/formats/E57Document.h"

namespace vestige {

/// decodeE57() may look at as many bytes behind the last value's.
constexpr std::size_t kReadAhead = 16;

/// The values that stand from bit `skip` (0 to 7) of `bytes` on (ASTM E2807, 9.7): floats little endian,
/// integers in their bits, the lowest first.
void decodeE57(const E57Field& field, const std::byte* bytes, unsigned skip, std::span<double> values);

/// Puts numbers of few bits one behind the other, as decodeE57() finds them.
class E57BitWriter {
  public:
    void put(std::uint64_t value, unsigned bits);
    /// The bytes so far, the last one filled up; none is left here, and bits that fill no byte stay unless
    /// `last`.
    std::vector<std::byte> take(bool last);

  private:
    std::vector<std::byte> bytes_;
    std::uint64_t pending_ = 0;
    unsigned used_ = 0;
};

}  // namespace vestige
