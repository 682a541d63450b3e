#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

#include "core/base/ScratchArray.h"

namespace vestige {

/// Allocates like ScratchArray (large arrays ask for large pages), and leaves items without a value where
/// none is given: resize() costs no time on zeros, so that many threads can fill an array whose memory they
/// are the first to touch.
template <class Item>
struct LargeAllocator {
    using value_type = Item;

    LargeAllocator() = default;
    template <class Other>
    LargeAllocator(const LargeAllocator<Other>&) noexcept {}

    Item* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(Item)) throw std::bad_alloc();
        return static_cast<Item*>(detail::newScratch(count * sizeof(Item)));
    }
    void deallocate(Item* items, std::size_t) noexcept { detail::FreeScratch{}(items); }

    template <class Other>
    void construct(Other* at) noexcept {
        ::new (static_cast<void*>(at)) Other;
    }
    template <class Other, class... Arguments>
    void construct(Other* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) Other(std::forward<Arguments>(arguments)...);
    }

    template <class Other>
    bool operator==(const LargeAllocator<Other>&) const noexcept {
        return true;
    }
};

/// A std::vector for the arrays of large clouds. Items are trivial types.
template <class Item>
using LargeArray = std::vector<Item, LargeAllocator<Item>>;

}  // namespace vestige
