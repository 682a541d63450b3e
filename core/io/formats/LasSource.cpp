#include "core/io/formats/LasSource.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/io/formats/LazReader.h"

namespace vestige {
namespace {

constexpr std::uint64_t kPlainRange = 262144;
/// A LASzip reader costs its opening and, where chunks vary, part of a chunk: not too many of them.
constexpr std::uint64_t kMostLazRanges = 64;
constexpr std::uint64_t kPlainRun = 256;
constexpr std::uint64_t kMostSampledChunks = 400;

}  // namespace

LasSource::LasSource(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job, bool drawn,
                     bool salvage)
    : file_(file), header_(header), job_(job), drawn_(drawn), salvage_(salvage) {
    if (header.compressed) plan_ = planLaz(file, header, job, salvage);
}

std::vector<LasRange> LasSource::ranges() const {
    std::uint64_t step = kPlainRange;
    if (header_.compressed) {
        step = plan_.chunkSize;
        if (step == 0) step = std::max<std::uint64_t>(1, points());
        const std::uint64_t chunks = (points() + step - 1) / step;
        step *= (chunks + kMostLazRanges - 1) / kMostLazRanges;
    }
    std::vector<LasRange> all;
    for (std::uint64_t begin = 0; begin < points(); begin += step)
        all.push_back({begin, std::min(begin + step, points())});
    return all;
}

std::vector<LasRange> LasSource::sample(std::uint64_t points) const {
    // Uncompressed: runs of a few pages. Compressed: the beginnings of some hundred chunks, whose layers have
    // to be fetched whole.
    const std::uint64_t all = this->points();
    if (all <= points) return ranges();
    std::uint64_t grid = 1;
    std::uint64_t runs = points / kPlainRun;
    if (header_.compressed) {
        if (plan_.chunkSize == 0) return {{0, points}};
        grid = plan_.chunkSize;
        runs = std::min<std::uint64_t>(kMostSampledChunks, (all + grid - 1) / grid);
    }
    runs = std::max<std::uint64_t>(1, runs);
    const std::uint64_t length = std::min(points / runs, std::max<std::uint64_t>(grid, kPlainRun));
    std::vector<LasRange> sampled;
    for (std::uint64_t run = 0; run < runs; ++run) {
        const std::uint64_t begin = all / runs * run / grid * grid;
        if (!sampled.empty() && begin < sampled.back().end) continue;
        sampled.push_back({begin, std::min(begin + length, all)});
    }
    return sampled;
}

std::uint64_t LasSource::read(std::span<const LasRange> ranges, const Handler& handle) {
    std::uint64_t total = 0;
    for (const LasRange& range : ranges) total += range.size();
    std::atomic<std::uint64_t> done{0};
    std::vector<std::uint64_t> whole(ranges.size());
    std::vector<std::string> damages(ranges.size());
    parallelChunks(ranges.size(), 1, [&](std::size_t range, std::size_t, std::size_t) {
        const LasRange& wanted = ranges[range];
        std::uint64_t unreported = 0;
        const LasBlockHandler each = [&](std::uint64_t first, std::span<const LasPoint> points) {
            handle(range, first, points);
            whole[range] += points.size();
            unreported += points.size();
            if (unreported < 65536) return;
            done += unreported;
            unreported = 0;
            job_.report(done, total);
        };
        try {
            if (header_.compressed)
                readLazPoints(file_, header_, plan_, drawn_, wanted.begin, wanted.end, job_, each);
            else
                readLasPoints(file_, header_, wanted.begin, wanted.end, each);
        } catch (const ErrorException& problem) {
            if (!salvage_ || problem.error.code != ErrorCode::input) throw;
            damages[range] = problem.error.message;
        }
        done += unreported;
    });
    std::uint64_t count = 0;
    for (std::size_t range = 0; range < ranges.size(); ++range) {
        count += whole[range];
        if (whole[range] == ranges[range].size()) continue;
        damage_ = damages[range];
        break;
    }
    return count;
}

}  // namespace vestige
