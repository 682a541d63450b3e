#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/BoundingBox.h"

namespace vestige {

/// A coordinate reference record of LAS (GeoTIFF keys or WKT), kept as its bytes so that rewriting loses
/// nothing.
struct CrsRecord {
    std::string userId;
    std::uint16_t recordId = 0;
    std::string description;
    std::vector<std::uint8_t> bytes;
    bool extended = false;  ///< from an EVLR
};

/// What a file says about itself; `info` prints it, writers carry on what their format can hold.
struct FileInfo {
    std::filesystem::path path;
    std::string format;   ///< "LAS", "PLY", ...
    std::string version;  ///< "1.4, point format 7"; empty where a format has none
    std::uint64_t points = 0;
    std::uint64_t triangles = 0;
    BoundingBox bounds;  ///< in the file's unit
    std::optional<Eigen::Vector3d> scale;
    std::optional<Eigen::Vector3d> offset;
    std::string crs;  ///< WKT, or the GeoTIFF keys in words; empty when the file names none
    std::vector<CrsRecord> crsRecords;
    bool gpsTimeIsAdjustedStandard = false;
    std::vector<std::string>
        attributes;  ///< "intensity", "color", "classification", "gps_time", "normals", ...
    std::optional<std::pair<double, double>> timeSpan;   ///< GPS time, s
    std::optional<std::pair<int, int>> creationDayYear;  ///< LAS: day of year, year
    std::string generatingSoftware;
    std::vector<std::string> warnings;  ///< what was skipped or repaired while reading
    std::string sha256;                 ///< filled where the whole file was read for it
};

}  // namespace vestige
