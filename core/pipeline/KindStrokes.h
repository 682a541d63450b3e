#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "core/measurement/MeasurementKind.h"

namespace vestige {

/// One line of what a measured path is drawn as; scene, metres.
struct KindStroke {
    std::vector<Eigen::Vector3d> points;
    bool closed = false;
};

/// What is measured of the picks of one repeat, as lines: the first is the one to be labelled. Of a distance
/// to a plane the perpendicular and the outline of the picks on the plane; of a box its edges; of a crush
/// profile the damage, the base line and the undamaged outline; of all else the line through the picks,
/// closed round an area. A single line through the picks where they do not determine more.
std::vector<KindStroke> strokesOf(MeasurementKind kind, const std::map<std::string, double>& settings,
                                  const std::vector<Eigen::Vector3d>& picks);

}  // namespace vestige
