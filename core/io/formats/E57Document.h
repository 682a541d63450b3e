#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/FileInfo.h"
#include "core/io/formats/E57Pages.h"

namespace vestige {

/// What a field of a scan's records means to Vestige; azimuth and elevation in rad.
enum class E57Role {
    none,
    x,
    y,
    z,
    range,
    azimuth,
    elevation,
    cartesianInvalid,
    sphericalInvalid,
    red,
    green,
    blue,
    colorInvalid,
    intensity,
    intensityInvalid,
    time,
    timeInvalid,
    normalX,
    normalY,
    normalZ,
    classification,
    pointSource,
    returnIndex,
    returnCount,
    count
};

/// How a field's values stand in their byte stream (ASTM E2807, 9): floats as they are, integers less their
/// minimum in as few bits as their range needs.
struct E57Field {
    enum class Type { float32, float64, integer, text };
    Type type = Type::float64;
    E57Role role = E57Role::none;
    std::int64_t minimum = 0;
    unsigned bits = 64;  ///< of a value; of a text the fewest
    double scale = 1;    ///< value = offset + scale * integer
    double offset = 0;
    double lowest = 0;  ///< the limits of the values that the prototype names, scaled
    double highest = 0;
};

struct E57Scan {
    ScanInfo info;
    std::vector<E57Field> fields;  ///< one byte stream each, in order
    std::uint64_t section = 0;     ///< logical
    std::uint64_t records = 0;
    std::size_t byte = 0;  ///< of its XML, for sentences
    std::array<std::pair<double, double>, 3> colorLimits{};
    double timeStart = 0;  ///< GPS seconds that its time stamps count from; 0 where the file does not say
    BoundingBox bounds;    ///< in the scan's frame, as the file says; empty where it does not

    /// The field of a role; fields.size() where there is none.
    std::size_t find(E57Role role) const;
    bool has(E57Role role) const { return find(role) < fields.size(); }
    bool hasAll(std::initializer_list<E57Role> roles) const;
};

/// What the XML section of an E57 file says.
struct E57Document {
    std::string coordinateMetadata;
    std::string library;
    std::optional<double> creation;  ///< GPS seconds
    std::vector<E57Scan> scans;
    std::vector<ImageInfo> images;
};

/// Checks and parses the XML section, and the sections that it points to: that they are inside the file, of
/// the right kind and long enough for what they are said to hold. Refuses at the byte otherwise.
E57Document readE57Document(const E57Pages& pages, ReadJob& job);

}  // namespace vestige
