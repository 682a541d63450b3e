#include "core/base/ScratchArray.h"

#include <sys/mman.h>

#include <cstdlib>

namespace vestige::detail {
namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;
constexpr std::size_t kLine = 64;

}  // namespace

void* newScratch(std::size_t bytes) {
    const std::size_t align = bytes >= 4 * kLargePage ? kLargePage : kLine;
    bytes = (bytes + align - 1) / align * align;
    void* const memory = std::aligned_alloc(align, bytes);
    if (!memory) throw std::bad_alloc();
    // Only a wish: where the system refuses, pages are small.
    if (align == kLargePage) madvise(memory, bytes, MADV_HUGEPAGE);
    return memory;
}

void FreeScratch::operator()(void* memory) const {
    std::free(memory);
}

}  // namespace vestige::detail
