#include "core/io/formats/UtmFrame.h"

#include <GeographicLib/Math.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <GeographicLib/UTMUPS.hpp>

namespace vestige {
namespace {

constexpr double kFalseEasting = 500000;
constexpr double kFalseNorthingSouth = 10000000;

int meridianOf(int zone) {
    return 6 * zone - 183;
}

}  // namespace

UtmFrame::UtmFrame(double latitude_deg, double longitude_deg)
    : zone_(GeographicLib::UTMUPS::StandardZone(latitude_deg, longitude_deg, GeographicLib::UTMUPS::UTM)),
      north_(latitude_deg >= 0) {}

Eigen::Vector2d UtmFrame::project(double latitude_deg, double longitude_deg) const {
    double x = 0, y = 0;
    GeographicLib::TransverseMercator::UTM().Forward(meridianOf(zone_), latitude_deg, longitude_deg, x, y);
    return {x + kFalseEasting, y + (north_ ? 0 : kFalseNorthingSouth)};
}

double UtmFrame::fromMeridian_deg(double longitude_deg) const {
    return GeographicLib::Math::AngDiff<double>(meridianOf(zone_), longitude_deg);
}

std::string UtmFrame::name() const {
    return "WGS 84 / UTM zone " + std::to_string(zone_) + (north_ ? "N" : "S");
}

std::string UtmFrame::wkt() const {
    return "PROJCS[\"" + name() +
           "\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
           "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]],"
           "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
           "PARAMETER[\"central_meridian\"," +
           std::to_string(meridianOf(zone_)) +
           "],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],"
           "PARAMETER[\"false_northing\"," +
           (north_ ? "0" : "10000000") + "],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"" +
           std::to_string((north_ ? 32600 : 32700) + zone_) + "\"]]";
}

CrsRecord UtmFrame::record() const {
    const std::string text = wkt();
    CrsRecord record{"LASF_Projection", 2112, "OGC WKT", {text.begin(), text.end()}, false};
    record.bytes.push_back(0);
    return record;
}

}  // namespace vestige
