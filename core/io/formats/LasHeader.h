#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/BoundingBox.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// A variable length record (LAS 1.0-1.4), its content as a part of the file.
struct LasRecord {
    std::string userId;
    std::uint16_t recordId = 0;
    std::string description;
    std::span<const std::byte> content;
    bool extended = false;
};

/// The public header block, checked against the size of the file.
struct LasHeader {
    int versionMinor = 0;
    std::uint16_t globalEncoding = 0;
    std::string generatingSoftware;
    int creationDay = 0;
    int creationYear = 0;
    std::size_t headerSize = 0;
    std::size_t pointOffset = 0;
    int pointFormat = 0;  ///< 0 to 10
    bool compressed = false;
    std::size_t recordLength = 0;
    std::uint64_t points = 0;          ///< that the file has room for
    std::uint64_t promisedPoints = 0;  ///< more than `points` only of a salvaged file
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    BoundingBox bounds;  ///< as the header states them
    std::vector<LasRecord> records;

    const LasRecord* find(std::string_view userId, std::uint16_t recordId) const;
};

/// Where a point format has what, by the tables of the LAS 1.4 specification; 0 where it has none.
struct LasPointLayout {
    std::size_t size = 0;  ///< bytes without extra bytes
    std::size_t gpsTime = 0;
    std::size_t color = 0;
    bool extended = false;  ///< formats 6 to 10
};
const LasPointLayout& lasPointLayout(int pointFormat);

/// Refuses, at its byte, a header that is not LAS 1.0 to 1.4 or does not fit the file. Damaged records after
/// the header are left out with a warning. With `salvage`, fewer points than promised are no reason.
LasHeader parseLasHeader(std::span<const std::byte> file, ReadJob& job, bool salvage = false);

}  // namespace vestige
