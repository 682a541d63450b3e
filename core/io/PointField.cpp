#include "core/io/PointField.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "core/base/CleanText.h"

namespace vestige {
namespace {

std::string plainName(std::string_view name) {
    std::string plain;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (plain.starts_with("scalar") && plain.size() > 6) plain.erase(0, 6);  // CloudCompare's PLY
    return plain;
}

const std::map<std::string, PointField, std::less<>>& knownNames() {
    using enum PointField;
    static const std::map<std::string, PointField, std::less<>> names{{"x", x},
                                                                      {"easting", x},
                                                                      {"y", y},
                                                                      {"northing", y},
                                                                      {"z", z},
                                                                      {"elevation", z},
                                                                      {"height", z},
                                                                      {"nx", normalX},
                                                                      {"normalx", normalX},
                                                                      {"ny", normalY},
                                                                      {"normaly", normalY},
                                                                      {"nz", normalZ},
                                                                      {"normalz", normalZ},
                                                                      {"r", red},
                                                                      {"red", red},
                                                                      {"diffusered", red},
                                                                      {"g", green},
                                                                      {"green", green},
                                                                      {"diffusegreen", green},
                                                                      {"b", blue},
                                                                      {"blue", blue},
                                                                      {"diffuseblue", blue},
                                                                      {"rgb", packedColor},
                                                                      {"rgba", packedColor},
                                                                      {"intensity", intensity},
                                                                      {"intensities", intensity},
                                                                      {"i", intensity},
                                                                      {"reflectance", intensity},
                                                                      {"reflectivity", intensity},
                                                                      {"remission", intensity},
                                                                      {"classification", classification},
                                                                      {"class", classification},
                                                                      {"gpstime", gpsTime},
                                                                      {"time", gpsTime},
                                                                      {"timeinsec", gpsTime},
                                                                      {"timestamp", gpsTime},
                                                                      {"t", gpsTime},
                                                                      {"pointsourceid", pointSource},
                                                                      {"pointsource", pointSource},
                                                                      {"returnnumber", returnNumber},
                                                                      {"numberofreturns", returnCount},
                                                                      {"returncount", returnCount}};
    return names;
}

/// Fields that mean something only together.
void dropIncomplete(std::vector<PointField>& fields, const std::array<PointField, 3>& group) {
    const bool whole = std::all_of(group.begin(), group.end(), [&](PointField field) {
        return std::count(fields.begin(), fields.end(), field) == 1;
    });
    if (whole) return;
    for (PointField& field : fields)
        if (std::count(group.begin(), group.end(), field) > 0) field = PointField::none;
}

}  // namespace

PointField fieldOfName(std::string_view name) {
    const auto known = knownNames().find(plainName(name));
    return known == knownNames().end() ? PointField::none : known->second;
}

std::vector<PointField> fieldsOfNames(const std::vector<std::string>& names, std::size_t line, ReadJob& job) {
    using enum PointField;
    std::vector<PointField> fields;
    std::set<PointField> seen;
    for (const std::string& name : names) {
        PointField field = fieldOfName(name);
        if (field != none && !seen.insert(field).second) {
            if (field == x || field == y || field == z)
                job.refuseLine(line, "the column " + cleanText(name) + " is named twice",
                               "one column each of x, y and z");
            field = none;
        }
        fields.push_back(field);
    }
    for (const auto& [field, name] : {std::pair(x, "x"), std::pair(y, "y"), std::pair(z, "z")})
        if (std::count(fields.begin(), fields.end(), field) == 0)
            job.refuseLine(line, std::string("no column is named ") + name, "one column each of x, y and z");
    dropIncomplete(fields, {normalX, normalY, normalZ});
    dropIncomplete(fields, {red, green, blue});
    if (std::count(fields.begin(), fields.end(), red) > 0)
        std::replace(fields.begin(), fields.end(), packedColor, none);
    constexpr std::size_t kMostNamed = 20;
    std::string unknown;
    std::size_t count = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (fields[i] != none || plainName(names[i]) == "alpha") continue;
        if (++count <= kMostNamed) unknown += (unknown.empty() ? "" : ", ") + cleanText(names[i]);
    }
    if (count > kMostNamed) unknown += " and " + std::to_string(count - kMostNamed) + " more";
    if (count > 0) job.warn("not kept: " + unknown);
    return fields;
}

}  // namespace vestige
