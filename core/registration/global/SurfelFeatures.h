#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/registration/global/Surfels.h"

namespace vestige {

/// How the surface round a surfel is shaped: fast point feature histograms (Rusu, Blodow, Beetz 2009) made
/// independent of the normals' signs. Of a pair (p, q) with u = n(p), d = (q - p) / |q - p|, v = u x d,
/// w = u x v: 10 bins of |v . n(q)|, 11 of u . d, 11 of the angle of (u . n(q), w . n(q)) modulo pi, in equal
/// steps of a monotone substitute of the angle. Turning n(p) round reverses the latter two. Each histogram's
/// shares are square-rooted (the Hellinger distance) and scaled to 255.
inline constexpr std::size_t kFeatureBins = 32;
using SurfelFeature = std::array<std::uint8_t, kFeatureBins>;

/// The feature of the same surfel with its normal turned round.
SurfelFeature reversed(const SurfelFeature& feature);

struct SurfelFeatures {
    std::vector<std::uint32_t> surfel;  ///< which surfels have one: where the surface bends
    std::vector<SurfelFeature> feature;
};

/// Features of at most `count` surfels, spread over those round which, within `radius_m`, the surface's
/// normals turn by a mean squared sine of at least `leastBend`.
SurfelFeatures featuresOf(const Surfels& surfels, double radius_m, double leastBend, std::size_t count);

}  // namespace vestige
