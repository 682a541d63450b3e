#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vestige {

/// Memory of `size` items that hold nothing yet, for kernels that fill it themselves: no time is lost on
/// zeros, and large arrays ask for large pages.
template <class Item>
class ScratchArray {
    static_assert(std::is_trivially_copyable_v<Item> && std::is_trivially_destructible_v<Item>);

  public:
    ScratchArray() = default;
    /// Throws std::bad_alloc.
    explicit ScratchArray(std::size_t size) : size_(size) {
        if (size == 0) return;
        constexpr std::size_t kLargePage = std::size_t{1} << 21;
        const std::size_t align = size * sizeof(Item) >= 4 * kLargePage ? kLargePage : 64;
        const std::size_t bytes = (size * sizeof(Item) + align - 1) / align * align;
        items_.reset(static_cast<Item*>(std::aligned_alloc(align, bytes)));
        if (!items_) throw std::bad_alloc();
#ifdef __linux__
        if (align == kLargePage) madvise(items_.get(), bytes, MADV_HUGEPAGE);
#endif
    }

    std::size_t size() const {
        return size_;
    }
    Item* data() {
        return items_.get();
    }
    const Item* data() const {
        return items_.get();
    }
    Item& operator[](std::size_t i) {
        return items_.get()[i];
    }
    const Item& operator[](std::size_t i) const {
        return items_.get()[i];
    }
    std::span<Item> span() {
        return {data(), size_};
    }
    std::span<const Item> span() const {
        return {data(), size_};
    }

  private:
    struct Free {
        void operator()(Item* items) const { std::free(items); }
    };
    std::unique_ptr<Item, Free> items_;
    std::size_t size_ = 0;
};

}  // namespace vestige
