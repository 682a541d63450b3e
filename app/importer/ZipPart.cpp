#include "app/importer/ZipPart.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace vestige::importer {
namespace {

[[noreturn]] void refuse(const ZipEntry& entry) {
    throw ErrorException{
        {ErrorCode::input, "'" + entry.name + "' in the archive is damaged", {}, "a whole archive"}};
}

/// zlib counts in 32 bits.
uInt most(std::size_t bytes) {
    return static_cast<uInt>(std::min<std::size_t>(bytes, std::numeric_limits<uInt>::max()));
}

}  // namespace

std::vector<std::byte> inflated(std::span<const std::byte> archive, const ZipEntry& entry) {
    const auto packed = archive.subspan(entry.data, entry.compressed);
    std::vector<std::byte> bytes;
    if (!entry.deflated) {
        bytes.assign(packed.begin(), packed.end());
    } else {
        z_stream stream{};
        if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
        std::size_t taken = 0;
        int state = Z_OK;
        constexpr std::size_t kPiece = std::size_t{1} << 20;
        while (state == Z_OK) {
            const std::size_t at = bytes.size();
            // One more byte than promised shows a stream that goes on.
            bytes.resize(std::min<std::size_t>(entry.size + 1, at + kPiece));
            if (bytes.size() == at) break;
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data() + taken));
            stream.avail_in = most(packed.size() - taken);
            stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + at);
            stream.avail_out = most(bytes.size() - at);
            const uInt offered = stream.avail_in, room = stream.avail_out;
            state = ::inflate(&stream, Z_NO_FLUSH);
            taken += offered - stream.avail_in;
            bytes.resize(at + room - stream.avail_out);
            if (offered == stream.avail_in && room == stream.avail_out) break;
        }
        ::inflateEnd(&stream);
        if (state != Z_STREAM_END) refuse(entry);
    }
    if (bytes.size() != entry.size) refuse(entry);
    uLong crc = ::crc32(0, nullptr, 0);
    for (std::size_t at = 0; at < bytes.size();) {
        const uInt piece = most(bytes.size() - at);
        crc = ::crc32(crc, reinterpret_cast<const Bytef*>(bytes.data() + at), piece);
        at += piece;
    }
    if (crc != entry.crc) refuse(entry);
    return bytes;
}

}  // namespace vestige::importer
