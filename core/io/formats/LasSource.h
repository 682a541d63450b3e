#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/PositionedFile.h"
#include "core/io/formats/LasPoints.h"
#include "core/io/formats/LazCheck.h"

namespace vestige {

/// Consecutive points of a file.
struct LasRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::uint64_t size() const { return end - begin; }
};

/// The points of a LAS or LAZ file, to be read in ranges by many threads.
class LasSource {
  public:
    /// Checks a compressed file's own records (planLaz). File, header and job outlive the source. `drawn`:
    /// only position, intensity, colour and the withheld flag need be right.
    LasSource(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job, bool drawn,
              bool salvage);

    /// That are there to be read.
    std::uint64_t points() const { return header_.compressed ? plan_.points : header_.points; }
    /// The whole file in ranges that can be read side by side without waste; the same for any thread count.
    std::vector<LasRange> ranges() const;

    /// About `points` points, spread over the file in runs that cost little to reach.
    std::vector<LasRange> sample(std::uint64_t points) const;

    /// Reads the ranges, each by one thread, and hands over blocks with the number of their range. Returns
    /// how many points of the ranges, one behind the other, are whole: all of them, unless the source
    /// salvages and met damage, which it then keeps; what was handed over behind them is not sure and must be
    /// dropped. Throws ErrorException when damaged and not salvaging, or cancelled.
    using Handler = std::function<void(std::size_t range, std::uint64_t first, std::span<const LasPoint>)>;
    std::uint64_t read(std::span<const LasRange> ranges, const Handler& handle);
    /// The same for the bare records of an uncompressed file.
    using RecordHandler = std::function<void(std::size_t range, std::uint64_t first, const std::byte* records,
                                             std::size_t count)>;
    void readRecords(std::span<const LasRange> ranges, const RecordHandler& handle) const;

    const LasHeader& header() const { return header_; }
    const ReadJob& job() const { return job_; }
    /// What ended reading; empty when nothing did.
    const std::string& damage() const { return damage_; }
    /// The table that says where the chunks of compressed points are is missing or damaged; salvaging reads
    /// without it.
    bool lacksTable() const { return plan_.withoutTable; }

  private:
    std::span<const std::byte> file_;
    const LasHeader& header_;
    const ReadJob& job_;
    bool drawn_;
    bool salvage_;
    LazPlan plan_;
    std::optional<PositionedFile> records_;  ///< of an uncompressed file
    std::string damage_;
};

/// The points of the ranges, in their order, as the options want them.
PointCloud gatherLas(LasSource& source, std::span<const LasRange> ranges, const ReadOptions& options,
                     ReadJob& job);

}  // namespace vestige
