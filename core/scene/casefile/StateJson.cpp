#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/scene/casefile/CaseJson.h"
#include "core/scene/casefile/SavedViewJson.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

Json parameterJson(const ParameterValue& value) {
    struct Visitor {
        Json operator()(std::monostate) const { return "auto"; }
        Json operator()(bool on) const { return on; }
        Json operator()(std::int64_t number) const { return number; }
        Json operator()(double number) const { return number; }
        Json operator()(const std::string& text) const { return text; }
    };
    return std::visit(Visitor{}, value);
}

void addParameters(Json& object, const ParameterSet& parameters) {
    for (const auto& spec : parameters.table()) object[spec.key] = parameterJson(parameters.value(spec.key));
}

ParameterValue readParameter(const JsonCursor& cursor, const ParameterSpec& spec) {
    const nlohmann::json& value = cursor.value();
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) {
        const double number = cursor.real();
        const bool whole = spec.type == ParameterType::integer && number == std::floor(number);
        constexpr std::int64_t kExact = std::int64_t{1} << 53;
        if (whole) return cursor.integer(-kExact, kExact);
        return number;
    }
    const std::string text = cursor.text();
    if (spec.mayBeAutomatic() && text == "auto") return std::monostate{};
    return text;
}

void readParameters(const JsonCursor& object, ParameterSet& parameters, std::string_view other = {}) {
    for (const auto& [key, member] : object.members()) {
        if (key == other || member.value().is_null()) continue;
        const ParameterSpec* spec = parameters.find(key);
        if (!spec) {
            member.warn("Vestige does not know this parameter and leaves it out");
            continue;
        }
        if (const Status set = parameters.set(key, readParameter(member, *spec)); !set)
            member.reject(set.error().message, set.error().hint);
    }
}

Site readSite(const JsonCursor& cursor) {
    cursor.warnOfOthers({"lat", "lon", "height_m"});
    Site site{cursor.at("lat").real(), cursor.at("lon").real(), 0};
    if (std::abs(site.latitude_deg) > 90)
        cursor.at("lat").reject("the latitude is beyond a pole", "expected degrees from -90 to 90");
    if (std::abs(site.longitude_deg) > 360)
        cursor.at("lon").reject("the longitude is out of range", "expected degrees from -180 to 180");
    if (const auto height = cursor.find("height_m")) site.height_m = height->real();
    return site;
}

/// Without the key it is the first aerial layer, else the first; a key of null says that there is none.
std::string readTarget(const JsonCursor& root, const SceneState& scene) {
    const auto registration = root.find("registration");
    if (registration && registration->contains("target")) {
        const auto target = registration->find("target");
        if (!target) return {};
        const std::string id = target->name();
        if (!scene.layer(id))
            target->reject("the case has no layer '" + id + "'", "expected the id of a layer");
        return id;
    }
    for (const auto& layer : scene.layers)
        if (layer.role == LayerRole::aerial) return layer.id;
    return scene.layers.empty() ? std::string() : scene.layers.front().id;
}

void readVersion(const JsonCursor& root) {
    if (!root.isObject() || !root.contains("vestige"))
        root.reject("this is no case of Vestige", R"(expected an object with "vestige": 1)");
    const double version = root.at("vestige").real();
    if (version != 1)
        root.at("vestige").reject("the case is of a version that this program does not know", "expected 1");
}

}  // namespace

Json caseJson(const SceneState& scene, const PathText& pathText) {
    Json json{{"vestige", 1}, {"name", scene.name}, {"operator", scene.operatorName}};
    if (scene.site)
        json["site"] = {{"lat", scene.site->latitude_deg},
                        {"lon", scene.site->longitude_deg},
                        {"height_m", scene.site->height_m}};
    json["layers"] = Json::array();
    for (const auto& layer : scene.layers) json["layers"].push_back(layerJson(layer, pathText));
    json["preprocess"] = Json::object();
    addParameters(json["preprocess"], scene.preprocess);
    json["registration"] = {{"target", scene.target.empty() ? Json() : Json(scene.target)}};
    addParameters(json["registration"], scene.registration);
    json["measurements"] = Json::array();
    for (const auto& measurement : scene.measurements)
        json["measurements"].push_back(measurementJson(measurement));
    for (const SavedView& view : scene.savedViews) json["saved_views"].push_back(savedViewJson(view));
    for (const SceneObject& object : scene.objects) json["objects"].push_back(objectJson(object));
    if (scene.views.empty()) return json;
    json["views"] = Json::object();
    for (const auto& [name, camera] : scene.views) {
        const auto frame = scene.viewFrames.find(name);
        json["views"][name] =
            viewJson(camera, frame == scene.viewFrames.end() ? std::string() : frame->second);
    }
    return json;
}

void readCaseJson(const JsonCursor& root, const std::filesystem::path& folder, SceneState& scene) {
    readVersion(root);
    root.warnOfOthers({"vestige", "name", "operator", "site", "layers", "preprocess", "registration",
                       "measurements", "objects", "views", "saved_views"});
    if (const auto name = root.find("name")) scene.name = name->text();
    if (const auto operatorName = root.find("operator")) scene.operatorName = operatorName->text();
    if (const auto site = root.find("site")) scene.site = readSite(*site);
    if (const auto layers = root.find("layers")) {
        std::set<std::string> ids;
        for (const auto& item : layers->elements()) {
            Layer layer = readLayer(item, scene.layers.size(), folder);
            if (!ids.insert(layer.id).second)
                item.at("id").reject("two layers are called '" + layer.id + "'", "expected ids that differ");
            scene.layers.push_back(std::move(layer));
        }
        const auto items = layers->elements();
        for (std::size_t i = 0; i < items.size(); ++i)
            if (const std::string to = referenceOf(scene.layers[i].init); !to.empty() && !scene.layer(to))
                items[i].at("init").at("to").warn("the case has no layer '" + to + "'");
    }
    if (const auto preprocess = root.find("preprocess")) readParameters(*preprocess, scene.preprocess);
    if (const auto registration = root.find("registration"))
        readParameters(*registration, scene.registration, "target");
    scene.target = readTarget(root, scene);
    if (const auto measurements = root.find("measurements")) {
        std::set<std::string> objects;
        for (const auto& item : measurements->elements()) {
            Measurement measurement = readMeasurement(item);
            if (!objects.insert(measurement.object).second)
                item.at("object").reject("two measurements are called '" + measurement.object + "'",
                                         "expected names that differ");
            scene.measurements.push_back(std::move(measurement));
        }
    }
    if (const auto saved = root.find("saved_views")) {
        std::set<std::string> names;
        for (const auto& item : saved->elements()) {
            SavedView view = readSavedView(item);
            if (!names.insert(view.name).second)
                item.at("name").reject("two saved views are called '" + view.name + "'",
                                       "expected names that differ");
            scene.savedViews.push_back(std::move(view));
        }
    }
    if (const auto objects = root.find("objects")) {
        std::set<std::string> names;
        for (const auto& item : objects->elements()) {
            SceneObject object = readObject(item);
            if (!names.insert(object.name).second)
                item.at("name").reject("two objects are called '" + object.name + "'",
                                       "expected names that differ");
            if (!scene.layer(object.layer))
                item.at("layer").warn("the case has no layer '" + object.layer + "'");
            scene.objects.push_back(std::move(object));
        }
    }
    if (const auto views = root.find("views")) {
        for (const auto& [name, view] : views->members()) {
            scene.views.emplace(name, readView(view));
            if (const auto frame = view.find("frame")) scene.viewFrames.emplace(name, frame->name());
        }
    }
}

}  // namespace vestige
