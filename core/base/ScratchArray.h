#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace vestige {

namespace detail {
/// Throws std::bad_alloc.
void* newScratch(std::size_t bytes);
struct FreeScratch {
    void operator()(void* memory) const;
};
}  // namespace detail

/// Memory of `size` items that hold nothing yet, for kernels that fill it themselves: no time is lost on
/// zeros, and large arrays ask for large pages.
template <class Item>
class ScratchArray {
    static_assert(std::is_trivially_copyable_v<Item> && std::is_trivially_destructible_v<Item>);

  public:
    ScratchArray() = default;
    /// Throws std::bad_alloc.
    explicit ScratchArray(std::size_t size)
        : items_(size == 0 ? nullptr : static_cast<Item*>(detail::newScratch(size * sizeof(Item)))),
          size_(size) {}

    std::size_t size() const { return size_; }
    Item* data() { return items_.get(); }
    const Item* data() const { return items_.get(); }
    Item& operator[](std::size_t i) { return items_.get()[i]; }
    const Item& operator[](std::size_t i) const { return items_.get()[i]; }
    std::span<Item> span() { return {data(), size_}; }
    std::span<const Item> span() const { return {data(), size_}; }

  private:
    std::unique_ptr<Item, detail::FreeScratch> items_;
    std::size_t size_ = 0;
};

}  // namespace vestige
