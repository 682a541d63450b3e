#include "core/io/formats/Unpack.h"

#include <zlib.h>

#include <limits>

namespace vestige {
namespace {

constexpr std::size_t kBestRatio = 256;
constexpr int kZlibOrGzip = 15 + 32;

/// Ends zlib's stream when it goes.
struct Stream {
    z_stream z{};
    ~Stream() { ::inflateEnd(&z); }
};

}  // namespace

std::vector<std::byte> inflated(std::span<const std::byte> stream, std::size_t size, std::size_t largest,
                                std::size_t offset, const ReadJob& job) {
    constexpr std::size_t kMostAtOnce = std::numeric_limits<uInt>::max();
    if (size > largest || size > kMostAtOnce || size / kBestRatio > stream.size())
        job.refuseByte(
            offset,
            "a packed part of " + counted(stream.size(), "byte") + " promises to unpack to " +
                counted(size, "byte"),
            "at most " + std::to_string(kBestRatio) + " times its size and " + counted(largest, "byte"));
    std::vector<std::byte> bytes(size + 1);  // one more shows a stream that holds more
    Stream state;
    if (::inflateInit2(&state.z, kZlibOrGzip) != Z_OK) throw std::bad_alloc();
    state.z.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(stream.data()));
    state.z.avail_in = static_cast<uInt>(std::min(stream.size(), kMostAtOnce));
    state.z.next_out = reinterpret_cast<Bytef*>(bytes.data());
    state.z.avail_out = static_cast<uInt>(bytes.size());
    const int end = ::inflate(&state.z, Z_FINISH);
    if (end != Z_STREAM_END || state.z.total_out != size)
        job.refuseByte(offset + state.z.total_in,
                       "a packed part is damaged: it unpacks to " + counted(state.z.total_out, "byte"),
                       "a zlib or gzip stream of " + counted(size, "byte"));
    bytes.pop_back();
    return bytes;
}

}  // namespace vestige
