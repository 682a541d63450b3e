#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// What a column, property or field of a point file means to Vestige.
enum class PointField {
    none,
    x,
    y,
    z,
    normalX,
    normalY,
    normalZ,
    red,
    green,
    blue,
    packedColor,  ///< 0x00RRGGBB, as PCD has it
    intensity,
    classification,
    gpsTime,
    pointSource,
    returnNumber,
    returnCount
};

/// By the names in use (CloudCompare's, PCL's, PDAL's, MeshLab's, ASL's), without regard to case, '_' and
/// quotes.
PointField fieldOfName(std::string_view name);

/// The fields of a file's columns. A field named twice counts at its first place. Refuses at `line` unless x,
/// y and z are there exactly once; normals and colours that are not whole are left out; names that mean
/// nothing here are warned of.
std::vector<PointField> fieldsOfNames(const std::vector<std::string>& names, std::size_t line, ReadJob& job);

}  // namespace vestige
