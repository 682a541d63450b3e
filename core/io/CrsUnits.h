#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/io/FileInfo.h"

namespace vestige {

/// The units that a coordinate reference system gives its coordinates, metres per unit; nothing where it
/// names none.
struct CrsUnits {
    std::optional<double> horizontal;
    std::optional<double> vertical;  ///< of a vertical system of its own
    bool degrees = false;            ///< the horizontal coordinates are latitudes and longitudes
};

/// Of a WKT text, 1 or 2: a projected, geocentric or geographic system, alone, compound or bound.
CrsUnits unitsOfWkt(std::string_view wkt);

/// Of LAS's records: the WKT where there is one that can be read, else the GeoTIFF keys (1.0, 6.3.1.3:
/// ProjLinearUnits 3076, their size 3077, VerticalUnits 4099; without them the projected system, where its
/// code is one of UTM's).
CrsUnits unitsOfRecords(const std::vector<CrsRecord>& records);

/// Sets `metresPerUnit`, where the format left it open, to what the file's reference system says; warns of
/// degrees and of heights in another unit.
void tellUnits(FileInfo& info);

}  // namespace vestige
