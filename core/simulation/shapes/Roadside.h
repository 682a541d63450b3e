#pragma once

#include "core/base/Random.h"
#include "core/simulation/ModelBuilder.h"

namespace vestige {

/// Half the width of the crowned road, and the height of its kerbs; metres.
inline constexpr double kRoadHalfWidth = 4.0;
inline constexpr double kKerbHeight = 0.12;

/// Height of the road's surface at y metres from its middle: a parabola 0.10 m high.
double crownHeight(double y);

/// Crowned road along x with kerbs and sloping pavements on both sides, `halfLength` either way.
void addCrownedRoad(ModelBuilder& builder, double halfLength);
/// A crash barrier along x at y: a corrugated beam on posts.
void addBarrier(ModelBuilder& builder, double fromX, double toX, double y, double ground);
/// A row of houses along x from -halfLength to halfLength, their fronts towards y = 0 at about `y`: windows
/// and doors set back, steps between the houses.
void addHouses(ModelBuilder& builder, double halfLength, double y, Random& random);
/// Pieces of plastic, glass and metal that lie round `centre` on the road.
void addDebris(ModelBuilder& builder, const Eigen::Vector3d& centre, int count, Random& random);

}  // namespace vestige
