#pragma once

#include "core/geometry/PointCloud.h"
#include "core/io/ReadOptions.h"
#include "core/io/formats/E57Document.h"

namespace vestige {

/// The points of every scan, one behind the other, in the file's frame, as far as the options want them.
/// Where the file has several scans each point's source is the number of its scan, from 1; where it has one,
/// it is what the records say. ScanInfo::points becomes the number of points with a position. `damage` gets a
/// sentence for each scan that is not whole.
PointCloud readE57Points(const E57Pages& pages, E57Document& document, const ReadOptions& options,
                         std::string& damage, ReadJob& job);

/// The names of the attributes that the scans have, as FileInfo holds them.
std::vector<std::string> e57Attributes(const E57Document& document);

}  // namespace vestige
