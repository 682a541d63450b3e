#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// One file of a zip archive. `data` is where its (compressed) bytes begin in the archive.
struct ZipEntry {
    std::string name;  ///< as in the archive, '/' between folders
    std::uint64_t data = 0;
    std::uint64_t compressed = 0;  ///< bytes in the archive
    std::uint64_t size = 0;        ///< bytes once inflated
    std::uint32_t crc = 0;
    bool deflated = false;  ///< else stored
};

struct ZipLimits {
    std::size_t entries = 65535;
    /// Inflated bytes of all entries: up to `freeBytes`, or `ratio` times the archive.
    std::uint64_t freeBytes = std::uint64_t{64} << 20;
    std::uint64_t ratio = 200;
};

/// The files of an archive (folders left out), from its central directory (APPNOTE.TXT 6.3, zip64 included),
/// nothing inflated. Refuses archives over the limits, encrypted and split ones, other methods than stored
/// and deflate, entries that overlap or leave the archive, names that are absolute, climb with "..", hold
/// '\\' or occur twice, and local headers that contradict the directory.
std::vector<ZipEntry> readZipDirectory(std::span<const std::byte> archive, const ZipLimits& limits,
                                       const ReadJob& job);

}  // namespace vestige
