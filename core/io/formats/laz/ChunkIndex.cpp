#include "core/io/formats/laz/ChunkIndex.h"

#include <array>
#include <memory>

#include "core/io/Bytes.h"
#include "core/io/formats/PatchedBuffer.h"
#include "core/io/formats/laz/IntegerDecoder.h"

namespace vestige::laz {
namespace {

constexpr std::size_t kTableHeader = 8;

struct Extent {
    std::uint64_t points;
    std::size_t bytes;
};

Extent extentOf(const WholeChunks& whole, std::size_t chunk) {
    const ChunkPlace& place = whole.chunks[chunk];
    if (chunk + 1 == whole.chunks.size()) return {whole.points - place.firstPoint, whole.end - place.begin};
    const ChunkPlace& next = whole.chunks[chunk + 1];
    return {next.firstPoint - place.firstPoint, next.begin - place.begin};
}

}  // namespace

std::size_t layerCount(const LasHeader& header) {
    constexpr std::size_t kPointLayers = 9;
    constexpr std::array<std::size_t, 5> kMoreLayers{0, 1, 2, 1, 3};
    const std::size_t extraBytes = header.recordLength - lasPointLayout(header.pointFormat).size;
    return kPointLayers + kMoreLayers.at(static_cast<std::size_t>(header.pointFormat - 6)) + extraBytes;
}

WholeChunks wholeChunks(std::span<const std::byte> file, const LasHeader& header, std::size_t limit) {
    const std::size_t layers = layerCount(header);
    const std::size_t head = header.recordLength + 4 + 4 * layers;
    WholeChunks whole{{}, 0, header.pointOffset + 8};
    while (limit > whole.end && limit - whole.end >= head) {
        const std::byte* sizes = file.data() + whole.end + header.recordLength + 4;
        std::size_t size = head;
        for (std::size_t layer = 0; layer < layers; ++layer) size += load<std::uint32_t>(sizes + 4 * layer);
        if (limit - whole.end < size) break;
        std::size_t at = whole.end + head;
        bool decodable = true;
        for (std::size_t layer = 0; layer < layers; ++layer) {
            const auto bytes = load<std::uint32_t>(sizes + 4 * layer);
            decodable = decodable && !beginsBeyondRange(file.subspan(at, bytes));
            at += bytes;
        }
        if (!decodable) break;
        whole.chunks.push_back({whole.points, whole.end});
        whole.points += load<std::uint32_t>(file.data() + whole.end + header.recordLength);
        whole.end += size;
    }
    return whole;
}

bool countsFit(const WholeChunks& whole, std::uint64_t chunkSize) {
    for (std::size_t chunk = 0; chunk < whole.chunks.size(); ++chunk) {
        const std::uint64_t points = extentOf(whole, chunk).points;
        if (points == 0) return false;
        const bool last = chunk + 1 == whole.chunks.size();
        if (chunkSize != 0 && (last ? points > chunkSize : points != chunkSize)) return false;
    }
    return true;
}

bool tableAgrees(std::span<const std::byte> table, const WholeChunks& whole, bool counts) {
    if (load<std::uint32_t>(table.data() + 4) != whole.chunks.size()) return false;
    RangeDecoder code(table.subspan(kTableHeader));
    const auto numbers = std::make_unique<IntegerDecoder<32, 2>>();
    std::uint32_t points = 0;
    std::uint32_t bytes = 0;
    for (std::size_t chunk = 0; chunk < whole.chunks.size(); ++chunk) {
        const Extent extent = extentOf(whole, chunk);
        if (counts) points = numbers->decode(code, points, 0);
        bytes = numbers->decode(code, bytes, 1);
        if (code.failed() || bytes != extent.bytes || (counts && points != extent.points)) return false;
    }
    return true;
}

}  // namespace vestige::laz
