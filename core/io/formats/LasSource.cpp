#include "core/io/formats/LasSource.h"

#include <algorithm>
#include <numeric>

#include "core/base/Parallel.h"
#include "core/io/formats/LazReader.h"

namespace vestige {
namespace {

constexpr std::uint64_t kPlainRange = 262144;
/// A LASzip reader costs its opening and, where chunks vary, part of a chunk: not too many of them.
constexpr std::uint64_t kMostLazRanges = 64;
constexpr std::uint64_t kPlainRun = 256;
constexpr std::uint64_t kMostSampledChunks = 400;
constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

}  // namespace

LasSource::LasSource(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job, bool drawn,
                     bool salvage)
    : file_(file), header_(header), job_(job), drawn_(drawn), salvage_(salvage) {
    if (header.compressed) {
        plan_ = planLaz(file, header, job, salvage);
        return;
    }
    auto opened = PositionedFile::open(job.path());
    if (!opened) throw ErrorException{opened.error()};
    records_.emplace(std::move(*opened));
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

namespace {

/// Tells how much is done, from many threads, not too often.
class Progress {
  public:
    Progress(const ReadJob& job, std::span<const LasRange> ranges) : job_(job) {
        for (const LasRange& range : ranges) total_ += range.size();
    }
    void add(std::uint64_t points) {
        const std::uint64_t before = done_.fetch_add(points);
        if (before / kStep != (before + points) / kStep) job_.report(before + points, total_);
    }

  private:
    static constexpr std::uint64_t kStep = 65536;
    const ReadJob& job_;
    std::uint64_t total_ = 0;
    std::atomic<std::uint64_t> done_{0};
};

}  // namespace

void LasSource::readRecords(std::span<const LasRange> ranges, const RecordHandler& handle) const {
    const std::size_t atOnce = std::max<std::size_t>(1, kBufferBytes / header_.recordLength);
    Progress progress(job_, ranges);
    parallelChunks(ranges.size(), 1, [&](std::size_t range, std::size_t, std::size_t) {
        thread_local std::vector<std::byte> buffer;
        buffer.resize(atOnce * header_.recordLength);
        for (std::uint64_t first = ranges[range].begin; first < ranges[range].end; first += atOnce) {
            const auto many =
                static_cast<std::size_t>(std::min<std::uint64_t>(atOnce, ranges[range].end - first));
            const std::size_t place = header_.pointOffset + first * header_.recordLength;
            if (!records_->readAt(place, std::span(buffer).first(many * header_.recordLength)))
                job_.refuseByte(place, "the file cannot be read on: it became shorter, or its device fails",
                                "a file that nobody changes meanwhile");
            handle(range, first, buffer.data(), many);
            progress.add(many);
        }
    });
}

std::uint64_t LasSource::read(std::span<const LasRange> ranges, const Handler& handle) {
    std::vector<std::uint64_t> whole(ranges.size());
    if (!header_.compressed) {
        readRecords(
            ranges, [&](std::size_t range, std::uint64_t first, const std::byte* records, std::size_t count) {
                decodeLasRecords(
                    records, count, header_, first,
                    [&](std::uint64_t at, std::span<const LasPoint> points) { handle(range, at, points); });
                whole[range] += count;
            });
        return std::accumulate(whole.begin(), whole.end(), std::uint64_t{0});
    }
    Progress progress(job_, ranges);
    std::vector<std::string> damages(ranges.size());
    parallelChunks(ranges.size(), 1, [&](std::size_t range, std::size_t, std::size_t) {
        try {
            readLazPoints(file_, header_, plan_, drawn_, ranges[range].begin, ranges[range].end, job_,
                          [&](std::uint64_t first, std::span<const LasPoint> points) {
                              handle(range, first, points);
                              whole[range] += points.size();
                              progress.add(points.size());
                          });
        } catch (const ErrorException& problem) {
            if (!salvage_ || problem.error.code != ErrorCode::input) throw;
            damages[range] = problem.error.message;
            const std::uint64_t chunk = plan_.sureTogether;
            whole[range] = chunk == 0 ? 0 : whole[range] / chunk * chunk;
        }
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
