#include <nlohmann/json.hpp>
#include <set>

#include "core/base/AtomicFile.h"
#include "core/simulation/SceneSpec.h"

namespace vestige {
namespace {

using Json = nlohmann::json;

/// A value of the file with its place in it, for error sentences.
struct Node {
    const Json& value;
    std::string file;
    std::string path;

    [[noreturn]] void bad(const std::string& message, const std::string& expected) const {
        throw ErrorException{{ErrorCode::input, message, file + ": " + path, expected}};
    }
    Node at(const std::string& key) const {
        const auto found = value.find(key);
        if (found == value.end()) bad("\"" + key + "\" is missing", "every scene has one");
        return {*found, file, path.empty() ? key : path + "." + key};
    }
    bool has(const std::string& key) const { return value.contains(key); }
    std::vector<Node> items() const {
        if (!value.is_array()) bad("this is not a list", "a JSON array");
        std::vector<Node> all;
        for (std::size_t i = 0; i < value.size(); ++i)
            all.push_back({value[i], file, path + "[" + std::to_string(i) + "]"});
        return all;
    }
    double number() const {
        if (!value.is_number()) bad("this is not a number", "a JSON number");
        return value.get<double>();
    }
    std::string text() const {
        if (!value.is_string()) bad("this is not a text", "a JSON string");
        return value.get<std::string>();
    }
    void object() const {
        if (!value.is_object()) bad("this is not an object", "a JSON object");
    }
    double number(const std::string& key, double otherwise) const {
        return has(key) ? at(key).number() : otherwise;
    }
    Eigen::Vector3d vector() const {
        const std::vector<Node> all = items();
        if (all.size() != 3) bad("this has " + std::to_string(all.size()) + " numbers", "three numbers");
        return {all[0].number(), all[1].number(), all[2].number()};
    }
};

/// Sets every key that is not in `known` as a parameter.
void readParameters(const Node& node, const std::set<std::string>& known, ParameterSet& set) {
    node.object();
    for (const auto& [key, value] : node.value.items()) {
        if (known.contains(key)) continue;
        const Node here = node.at(key);
        ParameterValue given;
        if (value.is_boolean()) {
            given = value.get<bool>();
        } else if (value.is_string()) {
            given = value.get<std::string>();
        } else {
            given = here.number();
        }
        if (const Status done = set.set(key, given); !done) here.bad(done.error().message, done.error().hint);
    }
}

ObjectSpec readObject(const Node& node) {
    node.object();
    const std::string kind = node.at("kind").text();
    const ShapeKind* shape = shapeKind(kind);
    if (!shape) {
        std::string all;
        for (const ShapeKind& one : shapeKinds()) all += (all.empty() ? "" : ", ") + std::string(one.name);
        node.at("kind").bad("there is no kind " + kind, all);
    }
    ObjectSpec object{node.at("id").text(),   shape, ParameterSet(shape->parameters()),
                      node.at("at").vector(), 0,     0};
    object.heading_deg = node.number("heading_deg", 0);
    object.roll_deg = node.number("roll_deg", 0);
    readParameters(node, {"id", "kind", "at", "heading_deg", "roll_deg"}, object.parameters);
    return object;
}

HandheldSpec readHandheld(const Node& node) {
    node.object();
    HandheldSpec layer{node.at("id").text(), node.at("object").text(), 0.001, {}};
    if (layer.id.empty() || layer.id.find_first_of("/\\") != std::string::npos)
        node.at("id").bad("this cannot name a file", "a name without slashes");
    layer.spacing_m = 0.001 * node.number("spacing_mm", 1);
    if (!(layer.spacing_m >= 0.0002 && layer.spacing_m <= 0.05))
        node.at("spacing_mm").bad("the spacing is out of range", "0.2 to 50");
    for (const Node& sweep : node.at("sweeps").items()) {
        SweepSpec one;
        one.fromStart = sweep.at("from").vector();
        one.fromEnd = sweep.has("from_end") ? sweep.at("from_end").vector() : one.fromStart;
        one.atStart = sweep.at("at").vector();
        one.atEnd = sweep.has("at_end") ? sweep.at("at_end").vector() : one.atStart;
        one.width_m = sweep.number("width_m", one.width_m);
        one.height_m = sweep.number("height_m", one.height_m);
        const double shots = sweep.number("shots", 1);
        if (!(shots >= 1 && shots <= 1000)) sweep.at("shots").bad("the number is out of range", "1 to 1000");
        if (!(one.width_m > 0 && one.width_m <= 2 && one.height_m > 0 && one.height_m <= 2))
            sweep.bad("the patch is out of range", "width_m and height_m above 0, up to 2");
        one.shots = static_cast<int>(shots);
        layer.sweeps.push_back(one);
    }
    return layer;
}

SiteSpec readSite(const Node& node) {
    node.object();
    SiteSpec site;
    site.latitude_deg = node.number("lat", site.latitude_deg);
    site.longitude_deg = node.number("lon", site.longitude_deg);
    site.height_m = node.number("height_m", site.height_m);
    site.easting_m = node.number("easting_m", site.easting_m);
    site.northing_m = node.number("northing_m", site.northing_m);
    const double zone = node.number("utm_zone", site.utmZone);
    if (!(zone >= 1 && zone <= 60)) node.at("utm_zone").bad("there is no such zone", "1 to 60");
    site.utmZone = static_cast<int>(zone);
    site.north = !node.has("hemisphere") || node.at("hemisphere").text() != "S";
    const double day = node.number("day", site.day);
    const double year = node.number("year", site.year);
    if (!(day >= 0 && day <= 366)) node.at("day").bad("there is no such day", "0 to 366");
    if (!(year >= 0 && year <= 9999)) node.at("year").bad("there is no such year", "0 to 9999");
    site.day = static_cast<int>(day);
    site.year = static_cast<int>(year);
    return site;
}

Result<SceneSpec> readScene(const Json& json, const std::string& file) {
    const Node root{json, file, ""};
    root.object();
    SceneSpec scene;
    scene.name = root.has("name") ? root.at("name").text() : "scene";
    if (root.has("site")) scene.site = readSite(root.at("site"));
    std::set<std::string> ids;
    for (const Node& node : root.at("objects").items()) {
        scene.objects.push_back(readObject(node));
        if (!ids.insert(scene.objects.back().id).second) node.at("id").bad("the id is used twice", "another");
    }
    if (root.has("flight")) readParameters(root.at("flight"), {}, scene.flight);
    if (root.has("photogrammetry")) readParameters(root.at("photogrammetry"), {}, scene.photogrammetry);
    if (root.has("handheld"))
        for (const Node& node : root.at("handheld").items()) scene.handheld.push_back(readHandheld(node));
    if (root.has("measurements"))
        for (const Node& node : root.at("measurements").items())
            scene.measurements.push_back({node.at("object").text(), node.at("tape_m").number(),
                                          node.at("from").text(), node.at("to").text()});
    return scene;
}

}  // namespace

Result<SceneSpec> readSceneSpec(const std::filesystem::path& file) {
    return guarded(file.string(), [&]() -> Result<SceneSpec> {
        const Result<std::string> text = readTextFile(file, std::size_t{64} << 20);
        if (!text) return fail(text.error());
        return readScene(Json::parse(*text), file.string());
    });
}

}  // namespace vestige
