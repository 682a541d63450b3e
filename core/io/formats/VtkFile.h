#pragma once

#include <string_view>

#include "core/geometry/TriangleMesh.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// What a legacy VTK file holds of points, polygons and point attributes, and how it is encoded.
struct VtkContent {
    TriangleMesh mesh;
    std::string version;  ///< "3.0, ascii"
};

/// Reads POLYDATA, UNSTRUCTURED_GRID and other data sets that list their POINTS. Normals, intensity and
/// colours of POINT_DATA are taken, everything else is passed over. Refuses, at line or byte, what does not
/// fit.
VtkContent readVtk(std::string_view file, ReadJob& job);

}  // namespace vestige
