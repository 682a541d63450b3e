#pragma once

#include <Eigen/Core>
#include <string>

#include "core/io/FileInfo.h"

namespace vestige {

/// UTM of one zone and hemisphere on WGS 84, for positions in and near the zone: the transverse Mercator
/// projection with scale 0.9996, false easting 500 km and, in the south, false northing 10 000 km.
class UtmFrame {
  public:
    /// The standard zone of a position (with the exceptions round Norway and Svalbard); degrees. Latitudes
    /// beyond the UTM's 84 and 80 degrees keep the zone of their longitude.
    UtmFrame(double latitude_deg, double longitude_deg);

    /// Easting and northing, m; some 5 nm exact within 35 degrees of the zone's meridian (GeographicLib,
    /// Karney 2011).
    Eigen::Vector2d project(double latitude_deg, double longitude_deg) const;
    /// Of a position against the zone's middle, -180 to 180 degrees.
    double fromMeridian_deg(double longitude_deg) const;

    int zone() const { return zone_; }
    bool north() const { return north_; }
    std::string name() const;  ///< "WGS 84 / UTM zone 32N"
    std::string wkt() const;   ///< WKT 1, with its EPSG code
    CrsRecord record() const;  ///< the same as a LAS record

  private:
    int zone_ = 31;
    bool north_ = true;
};

}  // namespace vestige
