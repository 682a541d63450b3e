#pragma once

#include <string_view>

#include "core/geometry/PointCloud.h"
#include "core/io/formats/PcdHeader.h"

namespace vestige {

/// The points behind a header. Points with a coordinate that is not finite (organised clouds mark holes so)
/// are left out with a warning. Refuses, at line or byte, what does not fit the header.
PointCloud readPcdBody(std::string_view file, const PcdHeader& header, ReadJob& job);

}  // namespace vestige
