#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/Parallel.h"

namespace vestige {

/// The values at `indices`, in their order, by many threads; nothing of an array that has nothing.
template <class Array>
Array selected(const Array& all, std::span<const std::uint32_t> indices) {
    constexpr std::size_t kGrain = 16384;
    Array chosen;
    if (all.empty()) return chosen;
    if constexpr (requires { chosen.resizeToFill(indices.size()); })
        chosen.resizeToFill(indices.size());
    else
        chosen.resize(indices.size());
    parallelFor(indices.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) chosen[i] = all[indices[i]];
    });
    return chosen;
}

}  // namespace vestige
