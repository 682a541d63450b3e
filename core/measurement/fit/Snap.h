#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/Result.h"
#include "core/geometry/Octree.h"
#include "core/geometry/Picking.h"
#include "core/geometry/Pose.h"
#include "core/measurement/FittedFeature.h"
#include "core/measurement/fit/ScannerPath.h"

namespace vestige {

/// A pick whose neighbourhood a feature is fitted to.
struct SnapRequest {
    const Octree* octree = nullptr;  ///< of the layer picked on
    Similarity sceneFromLayer;
    Eigen::Vector3d seed = Eigen::Vector3d::Zero();             ///< the point picked; scene, m
    Eigen::Vector3d viewDirection = -Eigen::Vector3d::UnitZ();  ///< unit, from the eye to the seed
    double sensorNoise_m = 0;                                   ///< of a single point, 1 sigma
    double radius_m = 0;  ///< of the neighbourhood; 0: from noise and spacing
    /// Of the layer's points, where it could be recovered: noise then has a direction, and edges are read
    /// from the beams that see them sharply.
    const ScannerPath* path = nullptr;
    double spotUpright_rad = 0;  ///< full width of the beam at half power, upright and level
    double spotLevel_rad = 0;
    ClipRegion clips;  ///< what it cuts away is not fitted to
    /// Points that are not shown (not 0), by index; they are not fitted to. Null: all are shown.
    const std::vector<std::uint8_t>* hidden = nullptr;
};

/// The feature of that kind nearest to where the view meets the seed, in the scene frame, metres. Modes:
/// `plane` the flat surface at the seed; `edge` the line where two surfaces meet, or where one ends; `corner`
/// where three meet, or where two edges of one do; `circle` a ring or disc, its position the centre;
/// `highest` and `lowest` the end of the surface upwards and downwards; `centroid` the middle of what lies
/// together round the seed. `point` is the seed itself with the noise of the sensor. The answer depends on
/// the points alone: no random numbers, no threads. ErrorCode::input with a sentence that says why no such
/// feature was found.
Result<FittedFeature> snapFeature(const SnapRequest& request, SnapMode mode);

/// The radius that is taken where a request gives none: so wide that noise averages out and that there are
/// points enough, 8 times the noise or the spacing, whichever is larger.
double snapRadius_m(double sensorNoise_m, double localSpacing_m);

}  // namespace vestige
