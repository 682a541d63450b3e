#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/io/PointField.h"
#include "core/io/ReadJob.h"
#include "core/io/ScalarType.h"

namespace vestige {

/// How a file's colour numbers are meant. `guess`: by the largest value, up to 1 fractions, up to 255 bytes,
/// else 16 bits.
enum class ColorDepth { bytes, words, guess };

/// Unit length or zero, whatever the file says.
Eigen::Vector3f cleanNormal(const Eigen::Vector3d& normal);

/// Where the values of one field of all points lie: the first at `offset`, each `step` bytes behind the one
/// before.
struct RecordColumn {
    PointField field = PointField::none;
    ScalarType type = ScalarType::float32;
    std::size_t offset = 0;
    std::size_t step = 0;
};

/// Binary points, record behind record (PLY, PCD) or field behind field (compressed PCD).
struct RecordLayout {
    std::vector<RecordColumn> columns;  ///< x, y and z among them
    std::endian order = std::endian::little;
    ColorDepth depth = ColorDepth::guess;
};

/// The cloud that PointSink makes of the same rows, by many threads. The same up to rounding: colours are
/// scaled before they are rounded, not behind it, and normals are floats before they are of unit length.
/// Nothing where a coordinate is not usable: reading row by row then tells what to say of it. `body` holds
/// all `points` points. Throws ErrorException when cancelled.
std::optional<PointCloud> readRecords(const std::byte* body, std::size_t points, const RecordLayout& layout,
                                      const ReadJob& job);

}  // namespace vestige
