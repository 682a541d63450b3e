#include "core/io/LoadEstimate.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace vestige {
namespace {

/// Position, colour and intensity; then the index and what its sorting takes for a while.
constexpr std::uint64_t kDrawnBytes = 21;
constexpr std::uint64_t kOtherAttributesBytes = 13;
constexpr std::uint64_t kIndexPeakBytes = 22;
/// Residuals, where there were none.
constexpr std::uint64_t kMovedBytes = 12;
constexpr std::uint64_t kTriangleBytes = 12;
/// Left to the rest of the machine.
constexpr double kShareToUse = 0.85;

std::uint64_t numberIn(const char* file) {
    std::ifstream stream(file);
    std::uint64_t number = 0;
    return stream >> number ? number : std::numeric_limits<std::uint64_t>::max();
}

std::uint64_t cachedFiles() {
    std::ifstream statistics("/sys/fs/cgroup/memory.stat");
    std::string name;
    for (std::uint64_t bytes = 0; statistics >> name >> bytes;)
        if (name == "inactive_file") return bytes;
    return 0;
}

std::string gigabytes(std::uint64_t bytes) {
    const auto tenths = static_cast<std::uint64_t>(std::llround(static_cast<double>(bytes) / 1e8));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), " ");
    return digits;
}

}  // namespace

std::string LoadEstimate::sentence() const {
    return grouped(points) + " points need " + gigabytes(bytes) + " of memory, " + gigabytes(availableBytes) +
           " are free";
}

LoadEstimate estimateLoad(const FileInfo& peeked, const ReadOptions& options, LoadedFor use) {
    LoadEstimate estimate;
    const std::uint64_t every = std::max<std::uint32_t>(1, options.keepEvery);
    estimate.points = peeked.points / every + (peeked.points % every == 0 ? 0 : 1);
    std::uint64_t perPoint = kDrawnBytes;
    if (use == LoadedFor::scene) perPoint += kIndexPeakBytes;
    if (use == LoadedFor::moving || (use == LoadedFor::metres && peeked.metresPerUnit.value_or(1) != 1))
        perPoint += kMovedBytes;
    if (options.attributes == ReadOptions::Attributes::all) perPoint += kOtherAttributesBytes;
    // In double: a header may promise anything.
    const auto bytesOf = [](std::uint64_t count, std::uint64_t each) {
        return static_cast<double>(count) * static_cast<double>(each);
    };
    const double whole = bytesOf(peeked.heldToRead, kDrawnBytes + kOtherAttributesBytes);
    const double fixed = bytesOf(peeked.triangles, kTriangleBytes) + (options.wholeFile() ? 0.0 : whole);
    const double bytes = fixed + bytesOf(estimate.points, perPoint);
    estimate.bytes = static_cast<std::uint64_t>(std::min(bytes, 1e18));
    estimate.availableBytes = availableMemory();
    const double usable = kShareToUse * static_cast<double>(estimate.availableBytes);
    if (bytes <= usable) return estimate;
    // A part is picked out of the whole where the format is read whole.
    const double left = usable - bytesOf(peeked.triangles, kTriangleBytes) - whole;
    estimate.partsHelp = left > 0;
    const double needed = left > 0 ? std::ceil(bytesOf(peeked.points, perPoint) / left) : 4e9;
    estimate.keepEveryToFit = static_cast<std::uint32_t>(std::clamp(needed, 2.0, 4e9));
    return estimate;
}

std::uint64_t availableMemory() {
    std::uint64_t available = std::numeric_limits<std::uint64_t>::max();
    std::ifstream memory("/proc/meminfo");
    std::string word;
    while (memory >> word) {
        if (word != "MemAvailable:") continue;
        std::uint64_t kibibytes = 0;
        if (memory >> kibibytes) available = 1024 * kibibytes;
        break;
    }
    const std::uint64_t limit = numberIn("/sys/fs/cgroup/memory.max");
    // Files that were read count as used until somebody needs the memory.
    const std::uint64_t counted = numberIn("/sys/fs/cgroup/memory.current");
    const std::uint64_t used = counted - std::min(counted, cachedFiles());
    if (limit != std::numeric_limits<std::uint64_t>::max() && used < limit)
        available = std::min(available, limit - used);
    return available;
}

}  // namespace vestige
