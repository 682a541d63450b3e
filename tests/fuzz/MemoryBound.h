#pragma once

#include <cstddef>

namespace vestige::fuzz {

/// While it lives, everything that the process allocates is counted; more alive at once than `fixed` bytes
/// and `perByte` for each byte of the input ends the run as a finding. One at a time.
class MemoryBound {
  public:
    MemoryBound(std::size_t inputBytes, std::size_t fixed, std::size_t perByte);
    ~MemoryBound();
    MemoryBound(const MemoryBound&) = delete;
    MemoryBound& operator=(const MemoryBound&) = delete;

    /// Once, before the first.
    static void install();
};

}  // namespace vestige::fuzz
