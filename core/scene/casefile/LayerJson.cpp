#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

Json initJson(const InitialPoseSpec& init, const PathText& pathText) {
    if (std::holds_alternative<InitAuto>(init)) return "auto";
    if (std::holds_alternative<InitIdentity>(init)) return "identity";
    Json json;
    if (const auto* picks = std::get_if<InitPicks>(&init)) json["picks"] = pathText(picks->picks);
    if (const auto* given = std::get_if<InitPose>(&init)) {
        json["pose"] = poseJson(given->targetFromSource.pose);
        json["scale"] = given->targetFromSource.scale;
    }
    if (const std::string to = referenceOf(init); !to.empty()) json["to"] = to;
    return json;
}

std::filesystem::path readPath(const JsonCursor& cursor, const std::filesystem::path& folder) {
    const std::filesystem::path path = cursor.name();
    if (path.native().find('\0') != std::string::npos) cursor.reject("the path holds a zero byte");
    return (path.is_absolute() ? path : folder / path).lexically_normal();
}

InitialPoseSpec readInit(const JsonCursor& init, const Layer& layer, const std::filesystem::path& folder) {
    const char* forms = R"(expected {"picks": CSV}, {"pose": [16], "scale": 0.001}, "auto" or "identity")";
    if (init.isText()) {
        if (init.text() == "auto") return InitAuto{};
        if (init.text() == "identity") return InitIdentity{};
        init.reject("'" + init.text() + "' is no first pose", forms);
    }
    if (!init.isObject()) init.reject("this is no first pose", forms);
    init.warnOfOthers({"picks", "pose", "scale", "to"});
    const auto other = init.find("to");
    const std::string to = other ? other->name() : std::string();
    if (to == layer.id)
        other->reject("the first pose of '" + to + "' leads to itself", "expected another layer");
    if (const auto picks = init.find("picks")) {
        if (init.find("pose")) init.reject("there are both picks and a pose here", forms);
        return InitPicks{readPath(*picks, folder), to};
    }
    const auto pose = init.find("pose");
    if (!pose) init.reject("there are neither picks nor a pose here", forms);
    const auto scale = init.find("scale");
    return InitPose{{readPose(*pose), scale ? scale->realAbove0() : layer.metresPerUnit()}, to};
}

std::optional<LengthUnit> readUnit(const JsonCursor& cursor) {
    const std::string text = cursor.text();
    if (text == "auto") return std::nullopt;
    const auto unit = lengthUnitFromSymbol(text);
    if (!unit)
        cursor.reject("'" + text + "' is no unit of length", "expected " + lengthUnitSymbols() + " or auto");
    return unit;
}

std::optional<FileEvidence> readEvidence(const JsonCursor& layer) {
    const auto hash = layer.find("sha256");
    if (!hash) return std::nullopt;
    FileEvidence evidence{hash->text(), 0, {}};
    for (char& digit : evidence.sha256)
        if (digit >= 'A' && digit <= 'F') digit = static_cast<char>(digit - 'A' + 'a');
    if (evidence.sha256.size() != 64 ||
        evidence.sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
        hash->reject("this is no SHA-256", "expected 64 hexadecimal digits");
    constexpr std::int64_t kLargest = std::int64_t{1} << 53;
    if (const auto bytes = layer.find("bytes"))
        evidence.bytes = static_cast<std::uint64_t>(bytes->integer(0, kLargest));
    if (const auto modified = layer.find("modified")) evidence.modified = modified->text();
    return evidence;
}

LayerRole readRole(const JsonCursor& cursor) {
    const std::string text = cursor.text();
    const auto role = layerRoleFromName(text);
    if (!role) cursor.reject("'" + text + "' is no role", "expected aerial, handheld or photogrammetry");
    return *role;
}

Json boxJson(const BoundingBox& box) {
    return {box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z()};
}

BoundingBox readBox(const JsonCursor& cursor) {
    const auto sides = cursor.elements(6, "a box [xmin, ymin, zmin, xmax, ymax, zmax]");
    BoundingBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = sides[axis].real();
        box.max[axis] = sides[axis + 3].real();
    }
    if (box.empty()) cursor.reject("a least coordinate of the box exceeds its greatest");
    return box;
}

}  // namespace

Json layerJson(const Layer& layer, const PathText& pathText) {
    Json json{{"id", layer.id},
              {"name", layer.name},
              {"role", name(layer.role)},
              {"method", layer.method},
              {"path", pathText(layer.path)}};
    if (layer.evidence) {
        json["sha256"] = layer.evidence->sha256;
        json["bytes"] = layer.evidence->bytes;
        if (!layer.evidence->modified.empty()) json["modified"] = layer.evidence->modified;
    }
    if (layer.unit) json["unit"] = symbol(*layer.unit);
    if (!std::holds_alternative<InitIdentity>(layer.init)) json["init"] = initJson(layer.init, pathText);
    if (layer.salvage) json["salvage"] = true;
    if (layer.keepEvery > 1) json["keep_every"] = layer.keepEvery;
    if (layer.box) json["box"] = boxJson(*layer.box);
    json["visible"] = layer.visible;
    json["tint"] = layer.tint;
    if (layer.cleaning) json["cleaning"] = cleaningJson(*layer.cleaning);
    if (layer.registration) json["registration"] = resultJson(*layer.registration);
    return json;
}

Layer readLayer(const JsonCursor& cursor, std::size_t place, const std::filesystem::path& folder) {
    cursor.warnOfOthers({"id", "name", "role", "method", "path", "sha256", "bytes", "modified", "unit",
                         "keep_every", "box", "init", "salvage", "visible", "tint", "cleaning",
                         "registration"});
    Layer layer;
    layer.id = cursor.at("id").name();
    layer.role = readRole(cursor.at("role"));
    layer.path = readPath(cursor.at("path"), folder);
    const auto shownName = cursor.find("name");
    layer.name = shownName ? shownName->text() : layer.id;
    const auto method = cursor.find("method");
    layer.method = method ? method->name() : std::string(defaultMethod(layer.role));
    layer.evidence = readEvidence(cursor);
    if (const auto unit = cursor.find("unit")) layer.unit = readUnit(*unit);
    if (const auto every = cursor.find("keep_every"))
        layer.keepEvery =
            static_cast<std::uint32_t>(every->integer(1, std::numeric_limits<std::int32_t>::max()));
    if (const auto box = cursor.find("box")) layer.box = readBox(*box);
    if (const auto init = cursor.find("init")) layer.init = readInit(*init, layer, folder);
    if (const auto salvage = cursor.find("salvage")) layer.salvage = salvage->boolean();
    if (const auto visible = cursor.find("visible")) layer.visible = visible->boolean();
    layer.tint = defaultTint(place);
    if (const auto tint = cursor.find("tint")) {
        const auto channels = tint->elements(3, "a colour [red, green, blue]");
        for (std::size_t i = 0; i < 3; ++i)
            layer.tint[i] = static_cast<std::uint8_t>(channels[i].integer(0, 255));
    }
    if (const auto cleaning = cursor.find("cleaning")) layer.cleaning = readCleaning(*cleaning);
    if (const auto result = cursor.find("registration")) layer.registration = readResult(*result);
    return layer;
}

bool sameText(const Layer& a, const Layer& b) {
    const PathText asTheyAre = [](const std::filesystem::path& path) { return path.generic_string(); };
    const auto sameCleaning = [](const auto& one, const auto& other) {
        return one == other || (one && other && *one == *other);
    };
    if (!sameCleaning(a.cleaning, b.cleaning)) return false;
    // Millions of points need not be spelled out for this.
    const auto text = [&](Layer layer) {
        layer.cleaning = nullptr;
        return layerJson(layer, asTheyAre);
    };
    return text(a) == text(b);
}

}  // namespace vestige
