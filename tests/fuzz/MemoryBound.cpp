#include "tests/fuzz/MemoryBound.h"

#include <sanitizer/allocator_interface.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace vestige::fuzz {
namespace {

std::atomic<long long> alive{0};
std::atomic<long long> most{std::numeric_limits<long long>::max()};

void onAllocation(const volatile void*, std::size_t size) {
    const long long now = alive.fetch_add(static_cast<long long>(size)) + static_cast<long long>(size);
    if (now <= most.load(std::memory_order_relaxed)) return;
    most = std::numeric_limits<long long>::max();  // what follows allocates too
    std::fprintf(
        stderr,
        "finding: %lld bytes are allocated at once (the last %zu), which this file does not justify\n", now,
        size);
    std::abort();
}

void onRelease(const volatile void* block) {
    if (block) alive -= static_cast<long long>(__sanitizer_get_allocated_size(block));
}

}  // namespace

void MemoryBound::install() {
    __sanitizer_install_malloc_and_free_hooks(onAllocation, onRelease);
}

MemoryBound::MemoryBound(std::size_t inputBytes, std::size_t fixed, std::size_t perByte) {
    most = alive + static_cast<long long>(fixed + perByte * inputBytes);
}

MemoryBound::~MemoryBound() {
    most = std::numeric_limits<long long>::max();
}

}  // namespace vestige::fuzz
