#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/PointCloud.h"

namespace vestige {

struct NamedCloud {
    std::string name;
    PointCloud cloud;
};

/// The clouds that filters are measured on: "room" (a room of 112 586 points, tiled 9 by 10), "street" (one
/// turn of a laser scanner), "tripod" (a simulated accident scene seen from one station, about a million
/// points) and "tripod x10" (ten of it on top of each other, 1 cm apart at random). Those of files are absent
/// where the file is.
std::optional<PointCloud> filterCloud(const std::string& name);

}  // namespace vestige
