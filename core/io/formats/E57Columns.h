#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/io/FileInfo.h"

namespace vestige {

/// One field of the records to write, and the bits of point `i` of the cloud in it.
struct E57Column {
    std::string element;
    std::string attributes;  ///< of the prototype's element: type and limits
    std::string value;       ///< of the prototype's element: one within the limits
    unsigned bits = 64;
    std::function<std::uint64_t(std::size_t i)> raw;
};

/// A scan to write: some points of a cloud.
struct E57Part {
    ScanInfo info;
    std::size_t points = 0;
    std::vector<std::uint32_t> members;  ///< which points of the cloud, in order; empty for all of them
    std::vector<E57Column> columns;
    BoundingBox bounds;    ///< in the scan's frame
    int colorMaximum = 0;  ///< 0 without colours
    std::optional<std::pair<double, double>> intensityLimits;
    bool intensityIsInteger = false;
    std::optional<double> timeStart;  ///< where the points have times

    /// The place in the cloud of the scan's point k.
    std::size_t member(std::size_t k) const { return members.empty() ? k : members[k]; }
};

/// The scans of a cloud: those of its source where the points' sources are their numbers, else one. The cloud
/// must outlive them.
std::vector<E57Part> e57Parts(const PointCloud& cloud, const FileInfo* source);

}  // namespace vestige
