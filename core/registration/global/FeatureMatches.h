#pragma once

#include <cstdint>
#include <vector>

#include "core/registration/global/SurfelFeatures.h"

namespace vestige {

/// Two surfels whose surroundings look alike.
struct SurfelMatch {
    std::uint32_t source;  ///< surfel
    std::uint32_t target;
    std::uint32_t distance;  ///< of the features: sum of absolute differences
};

/// For each source feature, either way round, the `perSource` nearest of the target's (exact search; ties by
/// index). In the order of the source's features.
std::vector<SurfelMatch> matchFeatures(const SurfelFeatures& target, const SurfelFeatures& source,
                                       std::size_t perSource);

}  // namespace vestige
