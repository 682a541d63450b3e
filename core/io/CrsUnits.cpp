#include "core/io/CrsUnits.h"

#include <cmath>
#include <span>

#include "core/base/Numbers.h"
#include "core/base/UnitWords.h"
#include "core/base/Units.h"
#include "core/io/Bytes.h"
#include "core/io/WktTree.h"

namespace vestige {
namespace {

/// A unit has a plausible length: more than a nanometre, less than a thousand kilometres.
std::optional<double> plausible(std::optional<double> metres) {
    if (metres && *metres > 1e-9 && *metres < 1e6) return metres;
    return std::nullopt;
}

/// The unit that stands at this level of the tree; in WKT 2 it may stand with the axes instead.
std::optional<double> linearUnit(const WktNode& system) {
    for (const char* keyword : {"UNIT", "LENGTHUNIT"})
        if (const WktNode* unit = system.child(keyword)) return plausible(unit->number(1));
    for (const WktNode& axis : system.children)
        if (axis.is("AXIS"))
            if (const WktNode* unit = axis.child("LENGTHUNIT")) return plausible(unit->number(1));
    return std::nullopt;
}

bool isAny(const WktNode& node, std::initializer_list<const char*> keywords) {
    for (const char* keyword : keywords)
        if (node.is(keyword)) return true;
    return false;
}

void collect(const WktNode& node, CrsUnits& units) {
    if (isAny(node, {"COMPD_CS", "COMPOUNDCRS", "BOUNDCRS", "SOURCECRS"})) {
        // Of a bound system the source is what the coordinates are in.
        for (const WktNode& child : node.children)
            if (isAny(child,
                      {"PROJCS", "PROJCRS", "PROJECTEDCRS", "GEOCCS", "GEODCRS", "GEOGCS", "GEOGCRS",
                       "GEOGRAPHICCRS", "GEODETICCRS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS", "VERT_CS",
                       "VERTCRS", "VERTICALCRS", "COMPD_CS", "COMPOUNDCRS", "BOUNDCRS", "SOURCECRS"}))
                collect(child, units);
    } else if (isAny(node, {"VERT_CS", "VERTCRS", "VERTICALCRS"})) {
        units.vertical = linearUnit(node);
    } else if (isAny(node, {"PROJCS", "PROJCRS", "PROJECTEDCRS", "GEOCCS", "LOCAL_CS", "ENGCRS",
                            "ENGINEERINGCRS"})) {
        units.horizontal = linearUnit(node);
    } else if (isAny(node, {"GEODCRS", "GEODETICCRS", "GEOGCS", "GEOGCRS", "GEOGRAPHICCRS"})) {
        const WktNode* axes = node.child("CS");
        const bool cartesian = axes && !axes->values.empty() && axes->values[0] == "Cartesian";
        if (cartesian)
            units.horizontal = linearUnit(node);
        else
            units.degrees = true;
    }
}

/// EPSG's codes of units of length that surveys use.
std::optional<double> lengthOfCode(unsigned code) {
    if (code == 9001) return 1;
    if (code == 9002) return metresPer(LengthUnit::foot);
    if (code == 9003) return metresPer(LengthUnit::usSurveyFoot);
    if (code == 9005) return 0.3047972654;  // Clarke's foot
    if (code == 1033) return 0.01;
    if (code == 1025) return 0.001;
    return std::nullopt;
}

/// WGS 84, NAD83 and ETRS89 in UTM.
bool isUtm(unsigned code) {
    return (code > 32600 && code <= 32660) || (code > 32700 && code <= 32760) ||
           (code >= 26901 && code <= 26923) || (code >= 25828 && code <= 25838);
}

class GeoKeys {
  public:
    GeoKeys(std::span<const std::uint8_t> keys, std::span<const std::uint8_t> doubles)
        : keys_(keys), doubles_(doubles) {}

    /// The value of a key that holds a code itself.
    std::optional<unsigned> code(unsigned id) const {
        const auto at = find(id);
        if (!at || word(*at + 1) != 0) return std::nullopt;
        return word(*at + 3);
    }
    std::optional<double> real(unsigned id) const {
        const auto at = find(id);
        if (!at || word(*at + 1) != 34736) return std::nullopt;
        const std::size_t place = 8 * std::size_t{word(*at + 3)};
        if (place + 8 > doubles_.size()) return std::nullopt;
        return load<double>(reinterpret_cast<const std::byte*>(doubles_.data()) + place);
    }
    std::optional<double> unit(unsigned codeKey, unsigned sizeKey) const {
        const auto found = code(codeKey);
        if (!found) return std::nullopt;
        return *found == 32767 ? plausible(real(sizeKey)) : lengthOfCode(*found);
    }

  private:
    std::optional<std::size_t> find(unsigned id) const {
        for (std::size_t at = 4; 2 * (at + 4) <= keys_.size(); at += 4)
            if (word(at) == id) return at;
        return std::nullopt;
    }
    std::uint16_t word(std::size_t at) const {
        return load<std::uint16_t>(reinterpret_cast<const std::byte*>(keys_.data()) + 2 * at);
    }

    std::span<const std::uint8_t> keys_;
    std::span<const std::uint8_t> doubles_;
};

CrsUnits unitsOfKeys(const GeoKeys& keys) {
    CrsUnits units;
    const auto model = keys.code(1024);
    units.degrees = model == 2U;
    units.horizontal = keys.unit(3076, 3077);
    if (!units.horizontal && isUtm(keys.code(3072).value_or(0))) units.horizontal = 1;
    units.vertical = keys.unit(4099, 4100);
    return units;
}

std::span<const std::uint8_t> contentOf(const std::vector<CrsRecord>& records, std::uint16_t id) {
    for (const CrsRecord& record : records)
        if (record.recordId == id) return record.bytes;
    return {};
}

}  // namespace

CrsUnits unitsOfWkt(std::string_view wkt) {
    CrsUnits units;
    if (const auto root = parseWkt(wkt)) collect(*root, units);
    return units;
}

CrsUnits unitsOfRecords(const std::vector<CrsRecord>& records) {
    const std::span<const std::uint8_t> wkt = contentOf(records, 2112);
    const CrsUnits units = unitsOfWkt({reinterpret_cast<const char*>(wkt.data()), wkt.size()});
    if (units.horizontal || units.degrees) return units;
    return unitsOfKeys(GeoKeys(contentOf(records, 34735), contentOf(records, 34736)));
}

void tellUnits(FileInfo& info) {
    if (info.metresPerUnit) return;
    const CrsUnits units = info.crsRecords.empty() ? unitsOfWkt(info.crs) : unitsOfRecords(info.crsRecords);
    info.metresPerUnit = units.horizontal;
    if (units.degrees)
        info.warnings.emplace_back(
            "the coordinates are latitudes and longitudes in degrees; no lengths can be measured in them");
    if (units.horizontal && units.vertical && std::abs(*units.vertical / *units.horizontal - 1) > 1e-7)
        info.warnings.push_back("the heights are in " + unitWords(*units.vertical) + ", the positions in " +
                                unitWords(*units.horizontal) +
                                "; lengths that are not level come out wrong until the file is converted");
}

}  // namespace vestige
