#include "core/io/formats/LayeredReader.h"

#include <algorithm>
#include <memory>

#include "core/io/formats/laz/LayeredChunk.h"

namespace vestige {
namespace {

constexpr std::uint64_t kBlock = 256;

/// The chunk that holds a point.
std::size_t chunkOf(const std::vector<laz::ChunkPlace>& chunks, std::uint64_t point) {
    const auto after = std::upper_bound(
        chunks.begin(), chunks.end(), point,
        [](std::uint64_t wanted, const laz::ChunkPlace& chunk) { return wanted < chunk.firstPoint; });
    return static_cast<std::size_t>(after - chunks.begin()) - 1;
}

}  // namespace

void readLayeredPoints(std::span<const std::byte> file, const LasHeader& header, const LazPlan& plan,
                       bool drawn, std::uint64_t begin, std::uint64_t end, const ReadJob& job,
                       const LasBlockHandler& handle) {
    const auto chunk = std::make_unique<laz::LayeredChunk>(laz::ChunkLayout{
        header.recordLength, laz::layerCount(header), header.pointFormat != 6, plan.asVersion3, drawn});
    std::array<LasPoint, kBlock> block;
    std::uint64_t wanted = begin;
    for (std::size_t number = begin < end ? chunkOf(plan.chunks, begin) : 0; wanted < end; ++number) {
        const laz::ChunkPlace& place = plan.chunks[number];
        const auto refuse = [&] {
            job.refuseByte(
                place.begin,
                "the compressed points from number " + std::to_string(place.firstPoint + 1) + " are damaged",
                "a whole LAZ file");
        };
        const std::uint64_t behind =
            number + 1 < plan.chunks.size() ? plan.chunks[number + 1].firstPoint : plan.points;
        if (!chunk->open(file.subspan(place.begin)) || chunk->points() < behind - place.firstPoint) refuse();
        const std::uint64_t last = std::min(end, behind);
        for (std::uint64_t first = place.firstPoint; first < last;) {
            const auto many = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, last - first));
            const std::span<LasPoint> points = std::span(block).first(many);
            if (!chunk->next(points)) refuse();
            // Those before the first one wanted had to be read, too.
            if (first + many > wanted)
                handle(wanted, points.subspan(static_cast<std::size_t>(wanted - first)));
            first += many;
            wanted = std::max(wanted, first);
        }
    }
}

}  // namespace vestige
