#pragma once

#include <cstdint>
#include <vector>

#include "core/base/Random.h"
#include "core/geometry/Pose.h"
#include "core/simulation/ModelBuilder.h"

namespace vestige {

/// A wooden pavilion overgrown with vines in a park, like the place of the ETH ASL "Gazebo" sequences: half
/// structured (paving, pillars, beams, benches, walls), half not (lawn, leaves, trees, a hedge). World frame:
/// metres, z up, the paving at z = 0, the pavilion along x round the origin.
SurfaceModel pavilionScene(std::uint64_t seed);

/// Its pieces, one file each.
void addPavilion(ModelBuilder& builder, Random& random);
void addPark(ModelBuilder& builder, Random& random);

/// `count` leaf facets of side `leaf_m` in any direction, spread over the box (or the ellipsoid in it).
void addLeaves(ModelBuilder& builder, const Eigen::Vector3d& centre, const Eigen::Vector3d& halfSize,
               int count, double leaf_m, bool ellipsoid, Random& random);

/// Height of the lawn without its bumps; 0 on the paving.
double pavilionGround(double x, double y);

/// worldFromScanner of `count` stops on a walk of about 18 m through the pavilion: the scanner about a metre
/// above the ground, its x axis along the walk but for some degrees, roll and pitch of about a degree.
std::vector<Pose> pavilionWalk(std::size_t count, std::uint64_t seed);

}  // namespace vestige
