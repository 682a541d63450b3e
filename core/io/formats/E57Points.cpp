#include "core/io/formats/E57Points.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/io/formats/E57Cloud.h"

namespace vestige {
namespace {

constexpr std::size_t kChunk = 32768;
/// Records of a preview that are read together: fewer would touch more pages for as many points.
constexpr std::uint64_t kRun = 64;

std::vector<E57Streams> streamsOf(const E57Pages& pages, const E57Document& document, bool salvage,
                                  const ReadJob& job) {
    std::vector<E57Streams> streams;
    streams.reserve(document.scans.size());
    std::uint64_t walked = 0;
    for (const E57Scan& scan : document.scans) {
        walked += streams.emplace_back(pages, scan, salvage, job).walked();
        if (walked > pages.logicalSize())
            job.refuseByte(scan.byte, "the scans have more bytes together than the file, so they share them",
                           "bytes of its own for every scan");
    }
    return streams;
}

std::uint64_t recordsOf(const std::vector<E57Streams>& streams) {
    std::uint64_t records = 0;
    for (const E57Streams& each : streams) records += each.records();
    return records;
}

std::string damageOf(const std::vector<E57Streams>& streams, const E57Document& document) {
    std::string damage;
    for (std::size_t i = 0; i < streams.size(); ++i)
        if (!streams[i].damage().empty())
            damage += (damage.empty() ? "scan " : "; scan ") + std::to_string(i + 1) + ": " +
                      std::to_string(streams[i].records()) + " of " +
                      counted(document.scans[i].records, "point") + " could be read: " + streams[i].damage();
    return damage;
}

}  // namespace

PointCloud readE57Points(const E57Pages& pages, E57Document& document, const ReadOptions& options,
                         std::string& damage, ReadJob& job) {
    const bool drawnOnly = options.attributes == ReadOptions::Attributes::drawn;
    const std::vector<E57Streams> streams = streamsOf(pages, document, options.salvage, job);
    damage = damageOf(streams, document);
    const std::uint64_t total = recordsOf(streams);
    E57Cloud cloud(document, options);
    if (options.wholeFile()) cloud.reserve(total);
    const std::size_t wave = kChunk * 2 * static_cast<std::size_t>(std::max(1, threadCount()));
    std::uint64_t done = 0;
    for (std::size_t place = 0; place < streams.size(); ++place) {
        const std::uint64_t records = streams[place].records();
        std::vector<E57Rows> rows((std::min<std::uint64_t>(records, wave) + kChunk - 1) / kChunk,
                                  E57Rows(document.scans[place], drawnOnly));
        cloud.beginScan(place);
        for (std::uint64_t first = 0; first < records; first += wave) {
            job.report(done + first, total);
            const std::uint64_t count = std::min<std::uint64_t>(wave, records - first);
            parallelChunks(count, kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                rows[chunk].decode(streams[place], first + begin, end - begin);
            });
            for (std::size_t chunk = 0; chunk * kChunk < count; ++chunk) cloud.add(rows[chunk]);
        }
        document.scans[place].info.points = cloud.endScan(job);
        done += records;
    }
    return std::move(cloud).build(job);
}

std::optional<PointCloud> previewE57Points(const E57Pages& pages, const E57Document& document,
                                           std::size_t points, ReadJob& job) {
    const std::vector<E57Streams> streams = streamsOf(pages, document, false, job);
    const std::uint64_t total = recordsOf(streams);
    if (points == 0 || total <= points) return std::nullopt;
    // A run from the beginning of every stride.
    const std::uint64_t stride = kRun * ((total + points - 1) / points);
    ReadOptions options;
    options.attributes = ReadOptions::Attributes::drawn;
    E57Cloud cloud(document, options);
    std::size_t runs = 0;
    for (std::size_t place = 0; place < streams.size(); ++place) {
        E57Rows rows(document.scans[place], true);
        cloud.beginScan(place);
        for (std::uint64_t first = 0; first < streams[place].records(); first += stride) {
            if (++runs % 1024 == 0) job.report(runs * stride, total);
            const std::uint64_t count = std::min(kRun, streams[place].records() - first);
            rows.check(streams[place], first, count, job);
            rows.decode(streams[place], first, count);
            cloud.add(rows);
        }
        cloud.endScan(job);
    }
    return std::move(cloud).build(job);
}

}  // namespace vestige
