#pragma once

#include "core/geometry/PointCloud.h"

namespace vestige {

/// Fewer surfels than this make no surface to search with.
inline constexpr std::size_t kFewestSurfels = 20;

/// The edge of the voxels that a search for the source's place works with, metres: a fortieth of the source's
/// radius, but not finer than the target's spacing and noise allow.
double searchVoxel(const PointCloud& target, const PointCloud& source, double scale, double sourceRadius_m);

/// Whether a source of this extent may show a part of a scene of that extent, or the other way round; metres.
bool plausibleExtent(double source_m, double target_m);

}  // namespace vestige
