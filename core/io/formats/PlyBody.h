#pragma once

#include <string_view>

#include "core/geometry/TriangleMesh.h"
#include "core/io/formats/PlyHeader.h"

namespace vestige {

/// Points and faces behind a header; other elements and lists are passed over. Refuses, at line or byte, what
/// does not fit the header.
TriangleMesh readPlyBody(std::string_view file, const PlyHeader& header, ReadJob& job);

}  // namespace vestige
