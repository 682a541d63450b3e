#include <cmath>
#include <nlohmann/json.hpp>

#include "core/scene/casefile/CaseJson.h"
#include "core/scene/casefile/KindJson.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

Json vectorJson(const Eigen::VectorXd& vector) {
    return std::vector<double>(vector.begin(), vector.end());
}

Json fittedJson(const FittedFeature& feature) {
    const Eigen::Matrix3d& c = feature.covariance;
    Json json{{"mode", name(feature.mode)}, {"position", vectorJson(feature.position)}};
    if (!feature.axis.isZero(0)) json["axis"] = vectorJson(feature.axis);
    if (feature.axisUncertainty > 0) json["axis_uncertainty_rad"] = feature.axisUncertainty;
    json["covariance"] = Json::array({c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)});
    if (feature.radius > 0) json["radius"] = feature.radius;
    if (feature.radiusUncertainty > 0) json["radius_uncertainty"] = feature.radiusUncertainty;
    json["rms"] = feature.rms;
    json["inliers"] = feature.inliers;
    return json;
}

Json endJson(const PickedPoint& point) {
    Json end{point.layer, vectorJson(point.position)};
    Json more = Json::object();
    if (point.localSpacing_m) more["spacing_m"] = *point.localSpacing_m;
    if (point.inLayerFrame) more["frame"] = "layer";
    if (point.fitted) more["fitted"] = fittedJson(*point.fitted);
    if (!more.empty()) end.push_back(std::move(more));
    return end;
}

Json pairJson(const std::string& key, const PickedPair& pair) {
    const auto isPlain = [&](const PickedPoint& point) {
        return point.layer == key && !point.localSpacing_m && !point.inLayerFrame && !point.fitted;
    };
    if (isPlain(pair.a) && isPlain(pair.b))
        return Json::array({vectorJson(pair.a.position), vectorJson(pair.b.position)});
    return {{"a", endJson(pair.a)}, {"b", endJson(pair.b)}};
}

Json aimJson(const Aim& aim) {
    Json json{{"view", aim.view}, {"pixel", vectorJson(aim.pixel)}, {"layers", aim.layers}};
    if (aim.snap != SnapMode::point) json["snap"] = name(aim.snap);
    return json;
}

constexpr const char* kPairForms =
    R"(expected [[x,y,z],[x,y,z]] or {"a": [layer, [x,y,z]], "b": [layer, [x,y,z]]})";

SnapMode readSnap(const JsonCursor& cursor) {
    const std::string text = cursor.text();
    const auto mode = snapModeFromName(text);
    if (!mode)
        cursor.reject("'" + text + "' is no feature that is fitted",
                      "expected point, plane, edge, corner, highest, lowest, circle or centroid");
    return *mode;
}

double notBelow0(const JsonCursor& cursor, std::string_view key) {
    const auto found = cursor.find(key);
    if (!found) return 0;
    const double value = found->real();
    if (value < 0) found->reject("this is not below 0");
    return value;
}

FittedFeature readFitted(const JsonCursor& cursor) {
    cursor.warnOfOthers({"mode", "position", "axis", "axis_uncertainty_rad", "covariance", "radius",
                         "radius_uncertainty", "rms", "inliers"});
    FittedFeature feature{.mode = readSnap(cursor.at("mode"))};
    feature.position = cursor.at("position").vector3();
    if (const auto axis = cursor.find("axis")) {
        feature.axis = axis->vector3();
        if (std::abs(feature.axis.norm() - 1) > 1e-6) axis->reject("an axis is a unit vector");
    }
    feature.axisUncertainty = notBelow0(cursor, "axis_uncertainty_rad");
    const JsonCursor covariance = cursor.at("covariance");
    const auto c = covariance.elements(6, "the covariance xx, xy, xz, yy, yz, zz");
    feature.covariance << c[0].real(), c[1].real(), c[2].real(), c[1].real(), c[3].real(), c[4].real(),
        c[2].real(), c[4].real(), c[5].real();
    if (feature.covariance.diagonal().minCoeff() < 0) covariance.reject("a variance is not below 0");
    feature.radius = notBelow0(cursor, "radius");
    feature.radiusUncertainty = notBelow0(cursor, "radius_uncertainty");
    feature.rms = notBelow0(cursor, "rms");
    if (const auto inliers = cursor.find("inliers"))
        feature.inliers = static_cast<std::size_t>(inliers->integer(0, std::int64_t{1} << 32));
    return feature;
}

PickedPoint readEnd(const JsonCursor& cursor) {
    if (!cursor.isArray()) cursor.reject("this is no end of a pair", kPairForms);
    const auto parts = cursor.elements();
    if (parts.size() < 2 || parts.size() > 3) cursor.reject("this is no end of a pair", kPairForms);
    PickedPoint point{parts[0].name(), parts[1].vector3(), {}, false};
    if (parts.size() == 3) {
        parts[2].warnOfOthers({"spacing_m", "frame", "fitted"});
        if (const auto spacing = parts[2].find("spacing_m")) {
            point.localSpacing_m = spacing->real();
            if (*point.localSpacing_m < 0) spacing->reject("a spacing is not below 0");
        }
        if (const auto frame = parts[2].find("frame")) {
            if (frame->text() != "layer")
                frame->reject("'" + frame->text() + "' is no frame", "expected layer");
            point.inLayerFrame = true;
        }
        if (const auto fitted = parts[2].find("fitted")) point.fitted = readFitted(*fitted);
    }
    return point;
}

PickedPair readPair(const JsonCursor& cursor, const std::string& key) {
    if (cursor.isObject()) {
        cursor.warnOfOthers({"a", "b"});
        return {readEnd(cursor.at("a")), readEnd(cursor.at("b"))};
    }
    const auto ends = cursor.elements(2, std::string_view(kPairForms).substr(9));
    return {{key, ends[0].vector3(), {}, false}, {key, ends[1].vector3(), {}, false}};
}

Aim readAim(const JsonCursor& cursor) {
    cursor.warnOfOthers({"view", "pixel", "layers", "snap"});
    const auto pixel = cursor.at("pixel").elements(2, "a pixel [x, y]");
    Aim aim{cursor.at("view").name(), {pixel[0].real(), pixel[1].real()}, {}};
    for (const auto& layer : cursor.at("layers").elements()) aim.layers.push_back(layer.name());
    if (const auto snap = cursor.find("snap")) aim.snap = readSnap(*snap);
    return aim;
}

}  // namespace

Json pickedPointJson(const PickedPoint& point) {
    return endJson(point);
}

PickedPoint readPickedPoint(const JsonCursor& cursor) {
    return readEnd(cursor);
}

Json measurementJson(const Measurement& measurement) {
    Json json{{"object", measurement.object}};
    if (measurement.tape_m) json["tape_m"] = *measurement.tape_m;
    if (measurement.tapeResolution_m) json["tape_resolution_m"] = *measurement.tapeResolution_m;
    addKindJson(json, measurement);
    Json picks = Json::object();
    for (const auto& [key, pairs] : measurement.picks) {
        picks[key] = Json::array();
        for (const auto& pair : pairs) picks[key].push_back(pairJson(key, pair));
    }
    json["picks"] = std::move(picks);
    if (measurement.aims.empty()) return json;
    Json aims = Json::object();
    for (const auto& [method, pairs] : measurement.aims) {
        aims[method] = Json::array();
        for (const auto& pair : pairs)
            aims[method].push_back(Json::array({aimJson(pair.a), aimJson(pair.b)}));
    }
    json["aims"] = std::move(aims);
    return json;
}

Measurement readMeasurement(const JsonCursor& cursor) {
    cursor.warnOfOthers({"object", "kind", "settings", "tape_m", "tape_resolution_m", "check_tolerance_m",
                         "picks", "paths", "aims"});
    Measurement measurement;
    measurement.object = cursor.at("object").name();
    if (const auto tape = cursor.find("tape_m")) measurement.tape_m = tape->realAbove0();
    if (const auto digit = cursor.find("tape_resolution_m"))
        measurement.tapeResolution_m = digit->realAbove0();
    readKind(cursor, measurement);
    if (const auto picks = cursor.find("picks")) {
        for (const auto& [key, pairs] : picks->members()) {
            auto& held = measurement.picks[key];
            for (const auto& pair : pairs.elements()) held.push_back(readPair(pair, key));
        }
    }
    if (const auto aims = cursor.find("aims")) {
        for (const auto& [method, pairs] : aims->members()) {
            auto& held = measurement.aims[method];
            for (const auto& pair : pairs.elements()) {
                const auto ends = pair.elements(2, "two aims [{view, pixel, layers}, {...}]");
                held.push_back({readAim(ends[0]), readAim(ends[1])});
            }
        }
    }
    return measurement;
}

}  // namespace vestige
