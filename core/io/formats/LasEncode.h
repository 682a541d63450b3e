#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/io/LasWriter.h"

namespace vestige {

/// The integers that a LAS file holds coordinates as: coordinate = integer * scale + offset.
struct LasGrid {
    Eigen::Vector3d scale;
    Eigen::Vector3d offset;

    std::array<std::int32_t, 3> integers(const Eigen::Vector3d& point) const;
    Eigen::Vector3d coordinates(const std::array<std::int32_t, 3>& integers) const;
};

/// The options' grid where the bounds fit into its integers; else the same scale round another offset of the
/// same grid; else a coarser scale.
LasGrid chooseGrid(const LasWriteOptions& options, const BoundingBox& bounds);

/// What the header counts.
struct LasTotals {
    std::uint64_t points = 0;
    std::array<std::uint64_t, 15> byReturn{};
    BoundingBox bounds;
};

/// Point `i` of a part as a record of format 6, or 7 when `colored` (LAS 1.4, tables 16 and 17).
std::vector<std::byte> encodePoint(const LasPart& part, std::size_t i,
                                   const std::array<std::int32_t, 3>& integers, bool colored,
                                   bool keepPointSource);

std::vector<std::byte> encodeRecord(const CrsRecord& record);
std::vector<std::byte> encodeExtendedRecord(const CrsRecord& record);

/// Where things are in the file, for the header.
struct LasPlan {
    bool colored = false;
    bool compressed = false;
    std::size_t pointOffset = 0;
    std::size_t records = 0;
    std::uint64_t extendedOffset = 0;
    std::size_t extendedRecords = 0;
};

constexpr std::size_t kLasHeaderSize = 375;
constexpr std::size_t lasRecordLength(bool colored) {
    return colored ? 36 : 30;
}

/// The public header block of LAS 1.4.
std::vector<std::byte> encodeHeader(const LasWriteOptions& options, const LasPlan& plan, const LasGrid& grid,
                                    const LasTotals& totals);

}  // namespace vestige
