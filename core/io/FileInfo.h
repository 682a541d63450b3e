#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/FileStamp.h"
#include "core/geometry/BoundingBox.h"
#include "core/geometry/Pose.h"

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

/// One of the scans that a file keeps apart (E57, PTX). Its points carry its number, from 1, as their point
/// source, and are in the file's frame.
struct ScanInfo {
    std::string name;
    std::string guid;
    std::uint64_t points = 0;
    Pose fileFromScan = Pose::Identity();  ///< where the scanner stood; identity where the file does not say
    std::string sensorVendor;
    std::string sensorModel;
    std::string sensorSerial;
};

/// A photograph or panorama inside a file.
struct ImageInfo {
    std::string name;
    std::string projection;  ///< "pinhole", "spherical", "cylindrical", "visual reference"
    std::string format;      ///< "jpeg", "png"
    std::uint64_t bytes = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::optional<Pose> fileFromImage;
};

/// What a file says about itself; `info` prints it, writers carry on what their format can hold.
struct FileInfo {
    std::filesystem::path path;
    std::string format;   ///< "LAS", "PLY", ...
    std::string version;  ///< "1.4, point format 7"; empty where a format has none
    std::uint64_t points = 0;
    std::uint64_t triangles = 0;
    std::uint64_t heldToRead =
        0;               ///< points that are held while a part of them is picked out; 0 where none are
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
    std::optional<double> metresPerUnit;  ///< where the format fixes or names the unit of its coordinates
    std::vector<ScanInfo> scans;          ///< of formats that keep scans apart
    std::vector<ImageInfo> images;
    /// Other files that hold a part of this one: tiles, buffers. Known once it was read.
    std::vector<std::filesystem::path> companions;
    std::vector<FileStamp> companionStamps;  ///< of each before it was read; all 0: it was not there
    std::vector<std::string> warnings;       ///< what was skipped or repaired while reading
    /// Of a salvaged file: what is missing, a sentence for the report; empty when whole. readGeometry() puts
    /// it before the warnings, too.
    std::string damage;
    std::string sha256;  ///< filled where the whole file was read for it
};

}  // namespace vestige
