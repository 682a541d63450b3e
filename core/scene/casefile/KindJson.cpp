#include "core/scene/casefile/KindJson.h"

#include <nlohmann/json.hpp>

#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/KindEdits.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

bool isPlain(const PickedPoint& point, const std::string& key) {
    PickedPoint plain;
    plain.layer = key;
    plain.position = point.position;
    return point == plain;
}

Json pathJson(const std::string& key, const PickedPath& path) {
    bool plain = true;
    for (const PickedPoint& point : path) plain = plain && isPlain(point, key);
    Json json = Json::array();
    for (const PickedPoint& point : path)
        json.push_back(plain ? Json{point.position.x(), point.position.y(), point.position.z()}
                             : pickedPointJson(point));
    return json;
}

/// Points are [x,y,z] on the layer of the key, or [layer, [x,y,z], {...}].
PickedPath readPath(const JsonCursor& cursor, const std::string& key) {
    const auto points = cursor.elements();
    if (points.size() > kMostPathPoints)
        cursor.reject("the path has " + std::to_string(points.size()) + " points",
                      "expected " + std::to_string(kMostPathPoints) + " at most");
    PickedPath path;
    for (const JsonCursor& point : points) {
        const bool placed = point.isArray() && !point.value().empty() && point.value().front().is_string();
        if (placed) {
            path.push_back(readPickedPoint(point));
            continue;
        }
        PickedPoint plain;
        plain.layer = key;
        plain.position = point.vector3();
        path.push_back(std::move(plain));
    }
    return path;
}

void readPaths(const JsonCursor& cursor, Measurement& measurement) {
    std::size_t points = 0;
    for (const auto& [key, paths] : cursor.members()) {
        auto& held = measurement.paths[key];
        for (const JsonCursor& path : paths.elements()) {
            held.push_back(readPath(path, key));
            points += held.back().size();
            if (points > kMostPointsOfAnObject)
                cursor.reject("the paths have more than " + std::to_string(kMostPointsOfAnObject) +
                              " points");
        }
    }
}

void readSettings(const JsonCursor& cursor, Measurement& measurement) {
    const ParameterTable& table = *kindSpec(measurement.kind).parameters;
    const ParameterSet known(table);
    for (const auto& [key, value] : cursor.members()) {
        if (!known.find(key)) {
            value.warn("the kind " + std::string(name(measurement.kind)) + " has no setting '" + key + "'");
            continue;
        }
        const double number = value.real();
        if (const auto set = kindSettings(measurement.kind, {{key, number}}); !set)
            value.reject(set.error().message, set.error().hint);
        measurement.settings[key] = number;
    }
}

}  // namespace

void addKindJson(Json& json, const Measurement& measurement) {
    if (measurement.kind != MeasurementKind::distance) json["kind"] = std::string(name(measurement.kind));
    if (!measurement.settings.empty()) {
        json["settings"] = Json::object();
        for (const auto& [key, value] : measurement.settings) json["settings"][key] = value;
    }
    if (measurement.checkTolerance_m) json["check_tolerance_m"] = *measurement.checkTolerance_m;
    if (measurement.paths.empty()) return;
    Json paths = Json::object();
    for (const auto& [key, all] : measurement.paths) {
        paths[key] = Json::array();
        for (const PickedPath& path : all) paths[key].push_back(pathJson(key, path));
    }
    json["paths"] = std::move(paths);
}

void readKind(const JsonCursor& cursor, Measurement& measurement) {
    if (const auto kind = cursor.find("kind")) {
        const auto found = measurementKindFromName(kind->text());
        if (!found) {
            std::string all;
            for (const KindSpec& spec : kindTable())
                all += (all.empty() ? "" : ", ") + std::string(name(spec.kind));
            kind->reject("'" + kind->text() + "' is no kind of measurement", "expected one of " + all);
        }
        measurement.kind = *found;
    }
    if (const auto settings = cursor.find("settings")) readSettings(*settings, measurement);
    if (const auto tolerance = cursor.find("check_tolerance_m"))
        measurement.checkTolerance_m = tolerance->realAbove0();
    if (const auto paths = cursor.find("paths")) readPaths(*paths, measurement);
}

}  // namespace vestige
