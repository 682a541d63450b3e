#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/simulation/shapes/Shapes.h"

namespace vestige {

/// One object of a synthetic scene. Site frame: metres, x east, y north, z up from the frame's origin.
struct ObjectSpec {
    std::string id;
    const ShapeKind* kind;
    ParameterSet parameters;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double heading_deg = 0;  ///< of the object's x axis, from the site's x towards y
    double roll_deg = 0;     ///< about its own x first; the object then rests on `at` with its lowest point
};

/// The handheld scanner swept in a straight line, in the frame of the layer's object, metres.
struct SweepSpec {
    Eigen::Vector3d fromStart;
    Eigen::Vector3d fromEnd;
    Eigen::Vector3d atStart;
    Eigen::Vector3d atEnd;
    double width_m = 0.4;   ///< of the patch that one shot covers, level
    double height_m = 0.3;  ///< across
    int shots = 1;
};

/// One layer of the handheld scanner.
struct HandheldSpec {
    std::string id;
    std::string object;  ///< id of the object that it was scanned on
    double spacing_m = 0.001;
    std::vector<SweepSpec> sweeps;
};

/// A taped length between two features "OBJECT.FEATURE".
struct MeasurementSpec {
    std::string object;
    double tape_m = 0;
    std::string from;
    std::string to;
};

/// Where the site lies: UTM and the same place as latitude and longitude.
struct SiteSpec {
    double latitude_deg = 39.084001;
    double longitude_deg = 117.213206;
    double height_m = 3.2;
    double easting_m = 518440;
    double northing_m = 4326120;
    int utmZone = 50;
    bool north = true;
    int day = 76;  ///< of the survey, written into the LAS header
    int year = 2025;
    double gpsTime_s = 100000000;  ///< at take-off, adjusted standard GPS time
};

/// Everything that a simulated survey depends on, apart from the seed.
struct SceneSpec {
    std::string name;
    SiteSpec site;
    std::vector<ObjectSpec> objects;
    ParameterSet flight;
    std::vector<HandheldSpec> handheld;
    ParameterSet photogrammetry;
    std::vector<MeasurementSpec> measurements;

    SceneSpec();
    const ObjectSpec* object(std::string_view id) const;
};

const ParameterTable& flightParameters();
const ParameterTable& photogrammetryParameters();

/// Night, open road: two cars after a collision and a box (the objects and tape lengths of table 5).
SceneSpec twoCarsScene();
/// Night, partly hidden: car, bicycle, boxes, cartons and a tripod by a row of trees (table 6).
SceneSpec bicycleScene();

/// A built-in scene's name ("two-cars", "bicycle") or a JSON file as docs/simulation.md describes it.
Result<SceneSpec> sceneSpec(const std::string& nameOrFile);
/// ErrorCode::input names the file and the JSON path.
Result<SceneSpec> readSceneSpec(const std::filesystem::path& file);

}  // namespace vestige
