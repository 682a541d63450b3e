#pragma once

#include <cstdint>
#include <string>

#include "core/io/FileInfo.h"
#include "core/io/ReadOptions.h"

namespace vestige {

/// What loading a file into the scene will take, told before it is done.
struct LoadEstimate {
    std::uint64_t points = 0;          ///< that will be kept; 0 when the format cannot tell before reading
    std::uint64_t bytes = 0;           ///< at the peak, index included
    std::uint64_t availableBytes = 0;  ///< of this machine or its container, now
    std::uint32_t keepEveryToFit = 1;  ///< the smallest thinning that fits
    bool partsHelp = true;             ///< false where the format has to be read whole, and does not fit

    bool fits() const { return keepEveryToFit <= 1; }
    /// "130 000 000 points need 4.2 GB, 3.1 GB are free": for the user.
    std::string sentence() const;
};

/// `peeked` is what peekFile() told; `indexed`: an octree is made of the points.
LoadEstimate estimateLoad(const FileInfo& peeked, const ReadOptions& options, bool indexed = true);

/// Bytes that this process may still take: the kernel's MemAvailable, or what the container's limit leaves.
std::uint64_t availableMemory();

}  // namespace vestige
