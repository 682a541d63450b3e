#pragma once

#include <cstddef>
#include <span>

namespace vestige {

/// What is kept of a record of a smoothed best estimate of trajectory: 17 little-endian doubles, namely GPS
/// time (s), latitude, longitude (rad), height (m), three velocities, roll, pitch, heading, wander angle,
/// three accelerations and three angular rates.
struct SbetRecord {
    static constexpr std::size_t kBytes = 17 * 8;

    double time = 0;
    double latitude_rad = 0;
    double longitude_rad = 0;
    double height_m = 0;
};

/// The record at the beginning of `bytes`, which are kBytes or more.
SbetRecord sbetRecord(std::span<const std::byte> bytes);

/// What is wrong with a position, as a sentence; nullptr when it is on Earth and its numbers are finite.
const char* sbetProblem(const SbetRecord& record);

/// True when every whole record in `bytes` is one that a vehicle or aircraft may have: finite, on Earth,
/// slower than 1 km/s, angles within two turns; and not all zero.
bool looksLikeSbet(std::span<const std::byte> bytes);

}  // namespace vestige
