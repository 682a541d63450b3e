#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>

namespace vestige::laz {

/// A point's return number and the number of returns of its pulse, each below 16.
struct Returns {
    std::uint8_t number = 0;
    std::uint8_t count = 0;

    /// 3 the only return, 1 the first, 2 the last, 0 one between.
    unsigned place() const { return (number == 1 ? 1U : 0U) + (number >= count ? 2U : 0U); }
    unsigned single() const { return count == 1 ? 1U : 0U; }
    /// How far from the last return, at most 7: the context of heights.
    unsigned depth() const {
        const int depth = count > number ? count - number : number - count;
        return depth < 7 ? static_cast<unsigned>(depth) : 7U;
    }
};

/// The six contexts of coordinates, by number of returns and return number (LASzip's choice, which also
/// covers what cannot be, such as return 3 of 2).
inline constexpr std::array<std::array<std::uint8_t, 16>, 16> kReturnContexts{{
    {0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5},
    {1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3},
    {2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3},
    {3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4},
    {4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4},
    {4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4},
    {5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4},
    {5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5},
    {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5},
}};

}  // namespace vestige::laz
