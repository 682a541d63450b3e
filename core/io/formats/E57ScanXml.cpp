#include "core/io/formats/E57ScanXml.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <pugixml.hpp>

#include "core/base/Numbers.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

constexpr int kDeepest = 16;
constexpr std::size_t kMostFields = 1024;
struct RoleName {
    const char* name;
    E57Role role;
};
/// ASTM E2807, table 12; the normals of the extension E57_NOR_surface_normals, class and source
/// of the one for LAS.
constexpr std::array kRoles{RoleName{"cartesianX", E57Role::x},
                            RoleName{"cartesianY", E57Role::y},
                            RoleName{"cartesianZ", E57Role::z},
                            RoleName{"sphericalRange", E57Role::range},
                            RoleName{"sphericalAzimuth", E57Role::azimuth},
                            RoleName{"sphericalElevation", E57Role::elevation},
                            RoleName{"cartesianInvalidState", E57Role::cartesianInvalid},
                            RoleName{"sphericalInvalidState", E57Role::sphericalInvalid},
                            RoleName{"colorRed", E57Role::red},
                            RoleName{"colorGreen", E57Role::green},
                            RoleName{"colorBlue", E57Role::blue},
                            RoleName{"isColorInvalid", E57Role::colorInvalid},
                            RoleName{"intensity", E57Role::intensity},
                            RoleName{"isIntensityInvalid", E57Role::intensityInvalid},
                            RoleName{"timeStamp", E57Role::time},
                            RoleName{"isTimeStampInvalid", E57Role::timeInvalid},
                            RoleName{"normalX", E57Role::normalX},
                            RoleName{"normalY", E57Role::normalY},
                            RoleName{"normalZ", E57Role::normalZ},
                            RoleName{"classification", E57Role::classification},
                            RoleName{"pointSourceId", E57Role::pointSource},
                            RoleName{"returnIndex", E57Role::returnIndex},
                            RoleName{"returnCount", E57Role::returnCount}};

class ScanParser {
  public:
    ScanParser(const pugi::xml_node& node, std::size_t number, const E57Xml& xml)
        : node_(node), name_("scan " + std::to_string(number)), xml_(xml) {}

    E57Scan parse() {
        scan_.byte = xml_.byteOf(node_);
        scan_.info.name = E57Xml::textOf(node_, "name");
        scan_.info.guid = E57Xml::textOf(node_, "guid");
        scan_.info.sensorVendor = E57Xml::textOf(node_, "sensorVendor");
        scan_.info.sensorModel = E57Xml::textOf(node_, "sensorModel");
        scan_.info.sensorSerial = E57Xml::textOf(node_, "sensorSerialNumber");
        scan_.info.fileFromScan = xml_.poseOf(node_).value_or(Pose::Identity());
        const double start = xml_.realOf(node_.child("acquisitionStart"), "dateTimeValue").value_or(0);
        scan_.timeStart = std::isfinite(start) ? start : 0;
        parseBounds();
        parsePoints();
        parseColorLimits();
        return std::move(scan_);
    }

  private:
    void parseBounds() {
        const pugi::xml_node bounds = node_.child("cartesianBounds");
        constexpr std::array kNames{"xMinimum", "xMaximum", "yMinimum", "yMaximum", "zMinimum", "zMaximum"};
        std::array<double, 6> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            // Files say infinity or the largest float where they do not know.
            const auto value = parseReal(trimmed(bounds.child(kNames[i]).text().get()));
            if (!bounds.child(kNames[i]) || (value && !(std::abs(*value) < 1e30))) return;
            values[i] = value.value_or(0);
        }
        scan_.bounds.min = {values[0], values[2], values[4]};
        scan_.bounds.max = {values[1], values[3], values[5]};
    }

    void parsePoints() {
        const pugi::xml_node points = node_.child("points");
        if (!points) xml_.refuse(node_, name_ + " has no points", "an element 'points'");
        if (std::strcmp(points.attribute("type").value(), "CompressedVector") != 0)
            xml_.refuse(points, "the points of " + name_ + " are of another type", "CompressedVector");
        const auto count = xml_.integerAttribute(points, "recordCount");
        if (!count || *count < 0)
            xml_.refuse(points, name_ + " does not say how many points it has", "a recordCount");
        scan_.records = static_cast<std::uint64_t>(*count);
        scan_.section = xml_.sectionOf(points);
        for (const pugi::xml_node codec : points.child("codecs").children())
            if (!codec.child("bitPackCodec"))
                xml_.refuse(codec, name_ + " is packed by a codec that is unknown", "bitPackCodec");
        addFields(points.child("prototype"), 0);
        scan_.info.points = scan_.records;
        checkFields(points);
    }

    void addFields(const pugi::xml_node& structure, int depth) {
        if (depth > kDeepest) xml_.refuse(structure, "the prototype is nested too deep", "16 levels at most");
        for (const pugi::xml_node child : structure.children()) {
            if (child.type() != pugi::node_element) continue;
            const std::string_view type = child.attribute("type").value();
            if (type == "Structure" || type == "Vector") {
                addFields(child, depth + 1);
                continue;
            }
            if (scan_.fields.size() >= kMostFields)
                xml_.refuse(child, "the prototype has too many fields", "at most 1024");
            scan_.fields.push_back(fieldOf(child, type));
            if (depth > 0) continue;
            for (const RoleName& known : kRoles)
                if (std::strcmp(localName(child), known.name) == 0 && !scan_.has(known.role))
                    scan_.fields.back().role = known.role;
        }
    }

    E57Field fieldOf(const pugi::xml_node& node, std::string_view type) const {
        E57Field field;
        if (type == "Float") {
            const bool single = std::strcmp(node.attribute("precision").value(), "single") == 0;
            field.type = single ? E57Field::Type::float32 : E57Field::Type::float64;
            field.bits = single ? 32 : 64;
            field.lowest = limitOf(node, "minimum").value_or(0);
            field.highest = limitOf(node, "maximum").value_or(1);
        } else if (type == "String") {
            field.type = E57Field::Type::text;
            field.bits = 8;
        } else if (type == "Integer" || type == "ScaledInteger") {
            using Limits = std::numeric_limits<std::int64_t>;
            field.type = E57Field::Type::integer;
            field.minimum = xml_.integerAttribute(node, "minimum").value_or(Limits::min());
            const std::int64_t maximum = xml_.integerAttribute(node, "maximum").value_or(Limits::max());
            if (field.minimum > maximum)
                xml_.refuse(node, "the least value of a field is above its largest", "minimum <= maximum");
            field.bits = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(maximum) -
                                                              static_cast<std::uint64_t>(field.minimum)));
            if (type == "ScaledInteger") {
                field.scale = xml_.attribute(node, "scale").value_or(1);
                field.offset = xml_.attribute(node, "offset").value_or(0);
            }
            field.lowest = field.offset + field.scale * static_cast<double>(field.minimum);
            field.highest = field.offset + field.scale * static_cast<double>(maximum);
            if (field.scale == 0 || !std::isfinite(field.lowest) || !std::isfinite(field.highest))
                xml_.refuse(node, "scale and offset of a field do not give usable numbers",
                            "finite numbers, and a scale that is not 0");
        } else {
            xml_.refuse(node, "a field of the prototype is of a type that records cannot have",
                        "Integer, ScaledInteger, Float or String");
        }
        return field;
    }

    /// The limits of floats say something of colours alone; infinite ones say nothing.
    std::optional<double> limitOf(const pugi::xml_node& node, const char* name) const {
        const std::optional<double> limit = parseReal(trimmed(node.attribute(name).value()));
        if (limit && !std::isfinite(*limit)) return std::nullopt;
        return xml_.attribute(node, name);
    }

    void checkFields(const pugi::xml_node& points) const {
        if (!scan_.hasAll({E57Role::x, E57Role::y, E57Role::z}) &&
            !scan_.hasAll({E57Role::range, E57Role::azimuth, E57Role::elevation}))
            xml_.refuse(points, "the points of " + name_ + " have no coordinates",
                        "cartesianX, Y, Z or sphericalRange, Azimuth, Elevation");
        for (const E57Field& field : scan_.fields)
            if (field.type == E57Field::Type::text && field.role != E57Role::none)
                xml_.refuse(points, "a field of " + name_ + " holds text", "numbers");
    }

    void parseColorLimits() {
        const pugi::xml_node limits = node_.child("colorLimits");
        constexpr std::array kNames{"colorRed", "colorGreen", "colorBlue"};
        constexpr std::array kChannels{E57Role::red, E57Role::green, E57Role::blue};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            if (!scan_.has(kChannels[channel])) continue;
            const E57Field& field = scan_.fields[scan_.find(kChannels[channel])];
            auto& [low, high] = scan_.colorLimits[channel];
            low = field.lowest;
            high = field.highest;
            // The range of a whole type is none of colours, nor is one value of a constant colour.
            if (!(high > low) || high - low > 4294967296.0) {
                high = low == high && high > 255 ? 65535 : 255;
                low = 0;
            }
            const std::string name = kNames[channel];
            const auto least = scaled(limits.child((name + "Minimum").c_str()));
            const auto largest = scaled(limits.child((name + "Maximum").c_str()));
            if (!least || !largest || !(*largest > *least) || !std::isfinite(*largest - *least)) continue;
            low = *least;
            high = *largest;
        }
    }

    std::optional<double> scaled(const pugi::xml_node& node) const {
        if (!node) return std::nullopt;
        return xml_.attribute(node, "offset").value_or(0) +
               xml_.attribute(node, "scale").value_or(1) * xml_.realOf(node);
    }

    const pugi::xml_node& node_;
    std::string name_;
    const E57Xml& xml_;
    E57Scan scan_;
};

}  // namespace

E57Scan parseE57Scan(const pugi::xml_node& node, std::size_t number, const E57Xml& xml) {
    return ScanParser(node, number, xml).parse();
}

}  // namespace vestige
