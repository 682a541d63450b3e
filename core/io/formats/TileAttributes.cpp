#include "core/io/formats/TileAttributes.h"

#include <utility>

namespace vestige {
namespace {

constexpr std::pair<PointField, const char*> kFieldNames[]{
    {PointField::intensity, "intensity"},        {PointField::classification, "classification"},
    {PointField::gpsTime, "gps_time"},           {PointField::pointSource, "point_source"},
    {PointField::returnNumber, "return_number"}, {PointField::returnCount, "return_count"}};

}  // namespace

void TileAttributes::add(const TileAttributes& other) {
    color |= other.color;
    normals |= other.normals;
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i] |= other.fields[i];
}

std::vector<std::string> TileAttributes::names() const {
    std::vector<std::string> list;
    for (const auto& [field, name] : kFieldNames) {
        if ((*this)[field]) list.emplace_back(name);
        if (field == PointField::intensity && color) list.emplace_back("color");
        if (field == PointField::gpsTime && normals) list.emplace_back("normals");
    }
    return list;
}

}  // namespace vestige
