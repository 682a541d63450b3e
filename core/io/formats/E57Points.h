#pragma once

#include <optional>

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

/// About `points` of them, spread over the scans, with the attributes that are drawn; of the pages only those
/// that are needed are checked. Nothing where the file has no more points than that.
std::optional<PointCloud> previewE57Points(const E57Pages& pages, const E57Document& document,
                                           std::size_t points, ReadJob& job);

}  // namespace vestige
