#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/filters/Ground.h"
#include "core/filters/UprightBox.h"

namespace vestige {

struct ObjectOptions {
    double gap_m = 0.12;
    std::size_t fewest = 40;  ///< points
    double smallest_m = 0.1;  ///< longest side
    double largest_m = 25;
    double highest_m = 6;  ///< above the ground
};

/// Points that hang together above the ground.
struct FoundObject {
    std::string kind;                   ///< "vehicle", "debris", "vegetation" (poles, too) or "other"
    std::vector<std::uint32_t> points;  ///< ascending
    UprightBox box;
    double above_m = 0;  ///< its lowest point above the ground
};

/// What a thing of this box is called: a vehicle is 2.2 m to 20 m long, 1.2 m to 3.2 m wide, 0.8 m to 4.6 m
/// high and reaches down to 0.6 m above the ground or lower; vegetation (or a pole) is over 1.5 m high and
/// over 1.5 times as high as it is wide; debris has no side over 2.2 m and is up to 1.5 m high. Other else.
std::string kindOf(const UprightBox& box, double above_m);

/// The things that stand above the ground, by connected cubes: the points above the ground's tolerance are
/// sorted into cubes, cubes that touch (26 neighbours) and hold points are one thing. Largest number of
/// points first, ties by the first point. Deterministic. ErrorCode::cancelled.
Result<std::vector<FoundObject>> findObjects(const UprightPoints& points, const GroundSurface& ground,
                                             const ObjectOptions& options, const JobControl& control = {});

}  // namespace vestige
