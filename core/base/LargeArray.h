#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/ScratchArray.h"

namespace vestige {

/// Allocates like ScratchArray (large arrays ask for large pages), and leaves items without a value where
/// none is given.
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
class LargeArray : public std::vector<Item, LargeAllocator<Item>> {
    using Base = std::vector<Item, LargeAllocator<Item>>;

  public:
    using Base::Base;
    explicit LargeArray(std::size_t count) { resize(count); }

    /// New items are as those of a std::vector: numbers zero, vectors of Eigen without a value.
    void resize(std::size_t count) {
        if constexpr (std::is_trivially_default_constructible_v<Item>)
            Base::resize(count, Item{});
        else
            Base::resize(count);
    }
    void resize(std::size_t count, const Item& value) { Base::resize(count, value); }
    /// New items have no value: no time is lost on zeros, and many threads can fill memory that they are the
    /// first to touch. Who calls it fills every item.
    void resizeToFill(std::size_t count) { Base::resize(count); }
    static LargeArray toFill(std::size_t count) {
        LargeArray array;
        array.resizeToFill(count);
        return array;
    }
};

}  // namespace vestige
