#include "core/io/formats/TileAttributes.h"

#include "core/io/AttributeNames.h"

namespace vestige {

void TileAttributes::add(const TileAttributes& other) {
    color |= other.color;
    normals |= other.normals;
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i] |= other.fields[i];
}

std::vector<std::string> TileAttributes::names() const {
    const auto& has = *this;
    return attributeNames({.intensity = has[PointField::intensity],
                           .color = color,
                           .classification = has[PointField::classification],
                           .gpsTime = has[PointField::gpsTime],
                           .normals = normals,
                           .pointSource = has[PointField::pointSource],
                           .returnNumber = has[PointField::returnNumber],
                           .returnCount = has[PointField::returnCount]});
}

}  // namespace vestige
