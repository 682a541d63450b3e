#include "core/io/formats/PntsTables.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/io/Bytes.h"
#include "core/io/formats/JsonPart.h"

namespace vestige {
namespace {

using nlohmann::json;

constexpr const char* kDraco = "3DTILES_draco_point_compression";

struct Semantic {
    const char* name;
    ScalarType type;
    std::size_t components;
};

constexpr Semantic kSemantics[]{
    {"POSITION", ScalarType::float32, 3},    {"POSITION_QUANTIZED", ScalarType::uint16, 3},
    {"RGBA", ScalarType::uint8, 4},          {"RGB", ScalarType::uint8, 3},
    {"RGB565", ScalarType::uint16, 1},       {"NORMAL", ScalarType::float32, 3},
    {"NORMAL_OCT16P", ScalarType::uint8, 2}, {"BATCH_ID", ScalarType::uint16, 1}};

constexpr const char* kGlobals[]{
    "POINTS_LENGTH",          "BATCH_LENGTH",  "RTC_CENTER", "QUANTIZED_VOLUME_OFFSET",
    "QUANTIZED_VOLUME_SCALE", "CONSTANT_RGBA", "extensions", "extras"};

std::optional<ScalarType> componentType(const std::string& name) {
    if (name == "BYTE") return ScalarType::int8;
    if (name == "UNSIGNED_BYTE") return ScalarType::uint8;
    if (name == "SHORT") return ScalarType::int16;
    if (name == "UNSIGNED_SHORT") return ScalarType::uint16;
    if (name == "INT") return ScalarType::int32;
    if (name == "UNSIGNED_INT") return ScalarType::uint32;
    if (name == "FLOAT") return ScalarType::float32;
    if (name == "DOUBLE") return ScalarType::float64;
    return std::nullopt;
}

std::size_t componentCount(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    return type == "VEC4" ? 4 : 0;
}

std::string textAt(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// An object inside another; null where there is none.
const json* objectAt(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? &*found : nullptr;
}

const json* dracoOf(const json& table) {
    const json* extensions = objectAt(table, "extensions");
    return extensions ? objectAt(*extensions, kDraco) : nullptr;
}

class TableParser {
  public:
    TableParser(std::span<const std::byte> bytes, const PntsHeader& header, bool salvage, ReadJob& job)
        : bytes_(bytes), header_(header), salvage_(salvage), job_(job) {}

    PntsTables parse() {
        const json table =
            parseJsonObject(textOf(bytes_, header_.featureJson), header_.featureJson.begin, {}, job_);
        parseGlobals(table);
        parseDraco(table);
        for (const Semantic& semantic : kSemantics) parseFeature(table, semantic);
        for (const auto& [name, value] : table.items())
            if (!isKnown(name)) tables_.notKept.push_back(name);
        checkPositions();
        if (tables_.feature("BATCH_ID")) tables_.notKept.push_back("BATCH_ID");
        parseBatchTable();
        if (header_.truncated && tables_.damage.empty()) tables_.damage = "the file ends early";
        if (!cutOff_.empty()) tables_.damage += "; without " + cutOff_;
        return std::move(tables_);
    }

  private:
    static bool isKnown(const std::string& name) {
        const auto same = [&](const auto& known) { return name == known; };
        return std::any_of(std::begin(kGlobals), std::end(kGlobals), same) ||
               std::any_of(std::begin(kSemantics), std::end(kSemantics),
                           [&](const Semantic& semantic) { return name == semantic.name; });
    }

    [[noreturn]] void refuseFeature(const std::string& message, const std::string& expected) const {
        job_.refuseByte(header_.featureJson.begin, message, expected);
    }

    void parseGlobals(const json& table) {
        tables_.points = globalCount(table, "POINTS_LENGTH", true);
        tables_.batches = globalCount(table, "BATCH_LENGTH", false);
        if (const auto centre = globalVector(table, "RTC_CENTER")) tables_.rtcCenter = *centre;
        const auto offset = globalVector(table, "QUANTIZED_VOLUME_OFFSET");
        const auto scale = globalVector(table, "QUANTIZED_VOLUME_SCALE");
        if (table.contains("POSITION_QUANTIZED") && !table.contains("POSITION") && !(offset && scale))
            refuseFeature("the quantised positions have no volume",
                          "QUANTIZED_VOLUME_OFFSET and QUANTIZED_VOLUME_SCALE");
        if (offset) tables_.volumeOffset = *offset;
        if (scale) tables_.volumeScale = *scale;
        const auto color = table.find("CONSTANT_RGBA");
        if (color == table.end() || !color->is_array() || color->size() < 3) return;
        tables_.constantColor.emplace();
        for (std::size_t i = 0; i < 3; ++i) {
            const double value = (*color)[i].is_number() ? (*color)[i].get<double>() : -1;
            if (!(value >= 0 && value <= 255))
                refuseFeature("CONSTANT_RGBA has a channel that is none", "numbers from 0 to 255");
            (*tables_.constantColor)[i] = static_cast<std::uint8_t>(value);
        }
    }

    std::size_t globalCount(const json& table, const char* name, bool required) const {
        if (const json* reference = objectAt(table, name))
            return load<std::uint32_t>(binary(*reference, name, 1, 4));
        const auto count = jsonCount(table, name, header_.featureJson.begin, job_);
        if (!count && required) refuseFeature(std::string("there is no ") + name, "the number of points");
        if (count.value_or(0) > 0xffffffff)
            refuseFeature(std::string(name) + " is " + std::to_string(*count), "at most 4294967295");
        return count.value_or(0);
    }

    std::optional<Eigen::Vector3d> globalVector(const json& table, const char* name) const {
        const auto found = table.find(name);
        if (found == table.end()) return std::nullopt;
        Eigen::Vector3d vector;
        if (found->is_object()) {
            const std::byte* data = binary(*found, name, 1, 12);
            for (int i = 0; i < 3; ++i) vector[i] = load<float>(data + 4 * i);
        } else {
            if (!found->is_array() || found->size() != 3 ||
                !std::all_of(found->begin(), found->end(), [](const json& v) { return v.is_number(); }))
                refuseFeature(std::string(name) + " is no vector", "three numbers");
            for (std::size_t i = 0; i < 3; ++i) vector[static_cast<int>(i)] = (*found)[i].get<double>();
        }
        if (!vector.allFinite()) refuseFeature(std::string(name) + " is not finite", "three numbers");
        return vector;
    }

    /// The bytes that a reference into the feature table's binary part means.
    const std::byte* binary(const json& reference, const std::string& name, std::size_t count,
                            std::size_t stride) const {
        const std::byte* data = array(reference, name, header_.featureBinary, count, stride);
        if (!data) refuseFeature("the file ends before " + name, "a whole feature table");
        return data;
    }

    /// Null when salvaging and the end of the file cuts it off.
    const std::byte* array(const json& reference, const std::string& name, const PntsSection& section,
                           std::size_t count, std::size_t stride) const {
        const auto offset = jsonCount(reference, "byteOffset", section.begin, job_);
        if (!offset) job_.refuseByte(section.begin, name + " does not say where it lies", "a byteOffset");
        if (*offset <= section.length && count <= (section.length - *offset) / stride)
            return bytes_.data() + section.begin + *offset;
        if (salvage_ && header_.truncated) return nullptr;
        job_.refuseByte(section.begin,
                        name + " needs " + counted(count, "value") + " of " + counted(stride, "byte") +
                            " from offset " + std::to_string(*offset) + " on, its section has " +
                            counted(section.length, "byte"),
                        "arrays within their section");
    }

    void parseDraco(const json& table) {
        const json* draco = dracoOf(table);
        if (!draco) return;
        const auto length = jsonCount(*draco, "byteLength", header_.featureJson.begin, job_);
        if (!length) refuseFeature("the Draco stream does not say its length", "a byteLength");
        if (!array(*draco, "the Draco stream", header_.featureBinary, *length, 1))
            refuseFeature("the file ends inside its Draco stream",
                          "a whole one: it cannot be decoded in parts");
        const std::size_t offset = *jsonCount(*draco, "byteOffset", header_.featureJson.begin, job_);
        tables_.draco = PntsSection{header_.featureBinary.begin + offset, *length};
    }

    std::optional<std::uint32_t> dracoId(const json& table, const std::string& name) const {
        const json* draco = tables_.draco ? dracoOf(table) : nullptr;
        const json* properties = draco ? objectAt(*draco, "properties") : nullptr;
        if (!properties) return std::nullopt;
        const auto id = jsonCount(*properties, name.c_str(), header_.featureJson.begin, job_);
        if (!id) return std::nullopt;
        return static_cast<std::uint32_t>(std::min<std::size_t>(*id, 0xffffffff));
    }

    void parseFeature(const json& table, const Semantic& semantic) {
        const json* reference = objectAt(table, semantic.name);
        if (!reference) return;
        PntsArray array{semantic.name, semantic.type, semantic.components, nullptr, {}, PointField::none};
        if (array.name == "BATCH_ID" && reference->contains("componentType")) {
            const auto type = componentType(textAt(*reference, "componentType"));
            if (!type || !isInteger(*type)) refuseFeature("BATCH_ID has no whole numbers", "UNSIGNED_SHORT");
            array.type = *type;
        }
        array.dracoId = dracoId(table, array.name);
        if (!array.dracoId) {
            if (header_.truncated && array.name.starts_with("POSITION"))
                keepWholePositions(*reference, array);
            array.data =
                this->array(*reference, array.name, header_.featureBinary, tables_.points, array.stride());
            if (!array.data) return leaveOut(array.name);
        }
        tables_.features.push_back(std::move(array));
    }

    void keepWholePositions(const json& reference, const PntsArray& array) {
        const std::size_t offset =
            jsonCount(reference, "byteOffset", header_.featureJson.begin, job_).value_or(0);
        const std::size_t length = header_.featureBinary.length;
        const std::size_t whole = offset < length ? (length - offset) / array.stride() : 0;
        tables_.damage = "the file ends early: " + std::to_string(std::min(whole, tables_.points)) + " of " +
                         counted(tables_.points, "point") + " were read";
        tables_.points = std::min(whole, tables_.points);
    }

    void leaveOut(const std::string& name) { cutOff_ += (cutOff_.empty() ? "" : ", ") + name; }

    void checkPositions() const {
        if (tables_.points > 0 && !tables_.feature("POSITION") && !tables_.feature("POSITION_QUANTIZED"))
            refuseFeature("the points have no positions", "POSITION or POSITION_QUANTIZED");
    }

    void parseBatchTable() {
        if (header_.batchTableCut) leaveOut("the batch table");
        if (header_.batchTableCut || header_.batchJson.length == 0) return;
        const json table =
            parseJsonObject(textOf(bytes_, header_.batchJson), header_.batchJson.begin, {}, job_);
        for (const auto& [name, value] : table.items()) {
            if (name == "extensions" || name == "extras") continue;
            const PointField field = propertyField(name);
            if (value.is_array())
                parseWritten(name, value, field);
            else if (value.is_object())
                parseProperty(table, name, value, field);
            else
                tables_.notKept.push_back(name);
        }
    }

    /// Properties have one meaning only if they are no coordinate, normal or colour.
    PointField propertyField(const std::string& name) const {
        const PointField field = fieldOfName(name);
        switch (field) {
            case PointField::intensity:
            case PointField::classification:
            case PointField::gpsTime:
            case PointField::pointSource:
            case PointField::returnNumber:
            case PointField::returnCount:
                return tables_.has(field) ? PointField::none : field;
            default:
                return PointField::none;
        }
    }

    std::size_t propertyLength() const {
        return tables_.feature("BATCH_ID") ? tables_.batches : tables_.points;
    }

    void parseProperty(const json& table, const std::string& name, const json& reference, PointField field) {
        const auto type = componentType(textAt(reference, "componentType"));
        const std::size_t components = componentCount(textAt(reference, "type"));
        if (!type || components == 0)
            job_.refuseByte(header_.batchJson.begin, "the property " + name + " has no known type",
                            "a componentType such as FLOAT, and SCALAR or VEC2 to VEC4");
        PntsArray array{name, *type, components, nullptr, {}, PointField::none};
        array.dracoId = dracoId(table, name);
        if (!array.dracoId) {
            array.data = this->array(reference, name, header_.batchBinary, propertyLength(), array.stride());
            if (!array.data) return leaveOut(name);
        }
        keepProperty(std::move(array), field);
    }

    /// Values that stand in the JSON itself.
    void parseWritten(const std::string& name, const json& values, PointField field) {
        const bool numbers =
            std::all_of(values.begin(), values.end(), [](const json& value) { return value.is_number(); });
        if (field == PointField::none || !numbers || values.size() < propertyLength()) {
            tables_.notKept.push_back(name);
            return;
        }
        std::vector<std::byte>& decoded = tables_.decoded.emplace_back(8 * values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            store(decoded.data() + 8 * i, values[i].get<double>());
        keepProperty({name, ScalarType::float64, 1, decoded.data(), {}, PointField::none}, field);
    }

    void keepProperty(PntsArray array, PointField field) {
        if (field == PointField::none || array.components != 1) {
            tables_.notKept.push_back(array.name);
            return;
        }
        array.field = field;
        tables_.properties.push_back(std::move(array));
    }

    std::span<const std::byte> bytes_;
    const PntsHeader& header_;
    bool salvage_;
    ReadJob& job_;
    PntsTables tables_;
    std::string cutOff_;
};

}  // namespace

const PntsArray* PntsTables::feature(std::string_view name) const {
    for (const PntsArray& array : features)
        if (array.name == name) return &array;
    return nullptr;
}

bool PntsTables::has(PointField field) const {
    return std::any_of(properties.begin(), properties.end(),
                       [&](const PntsArray& array) { return array.field == field; });
}

TileAttributes PntsTables::attributes() const {
    TileAttributes attributes;
    attributes.color = feature("RGBA") || feature("RGB") || feature("RGB565") || constantColor;
    attributes.normals = feature("NORMAL") || feature("NORMAL_OCT16P");
    for (const PntsArray& property : properties) attributes[property.field] = true;
    return attributes;
}

PntsTables parsePntsTables(std::span<const std::byte> bytes, const PntsHeader& header, bool salvage,
                           ReadJob& job) {
    return TableParser(bytes, header, salvage, job).parse();
}

}  // namespace vestige
