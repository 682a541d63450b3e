#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vestige {

/// The points of each occupied cell of a grid, in ascending order of their index.
struct CellMembers {
    std::vector<std::uint32_t> order;   ///< indices into the cloud, cell after cell
    std::vector<std::uint32_t> begins;  ///< of each cell in `order`, and its end

    std::size_t cellCount() const { return begins.empty() ? 0 : begins.size() - 1; }
    std::span<const std::uint32_t> points(std::size_t cell) const {
        return std::span(order).subspan(begins[cell], begins[cell + 1] - begins[cell]);
    }
};

}  // namespace vestige
