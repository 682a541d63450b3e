#pragma once

#include <string>
#include <vector>

#include "core/io/FileInfo.h"
#include "core/io/formats/LasHeader.h"

namespace vestige {

/// The coordinate reference records of a file, WKT and GeoTIFF, as they are.
std::vector<CrsRecord> crsRecords(const LasHeader& header);

/// What they say: the WKT if there is one, else the GeoTIFF keys in words ("projected EPSG:26915; ...").
/// Empty when there is none. Damaged keys are warned of.
std::string crsText(const std::vector<CrsRecord>& records, ReadJob& job);

}  // namespace vestige
