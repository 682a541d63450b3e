#pragma once

#include <cstddef>

namespace vestige {

/// What the kernel answers with SIGBUS: a page of a mapped file that is not there any more, since the file
/// was cut off by somebody else, or that the disk cannot read. Where a range is watched, the rest of it
/// becomes zeros and the fault is remembered; the reader goes on, and its result is to be thrown away. Faults
/// anywhere else end the program as they do without this.
class MappingWatch {
  public:
    /// Watches `size` bytes from a page's begin on, until destroyed; to be destroyed before the range is
    /// unmapped. With more ranges than there are places (1024), the last ones are not watched.
    MappingWatch(const void* begin, std::size_t size);
    ~MappingWatch();
    MappingWatch(MappingWatch&& other) noexcept;
    MappingWatch& operator=(MappingWatch&&) = delete;

    bool faulted() const;

  private:
    int place_ = -1;
};

}  // namespace vestige
