#include "core/io/formats/ZipDirectory.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::uint32_t kEnd64 = 0x06064b50, kLocator64 = 0x07064b50;
constexpr std::size_t kLocalSize = 30, kCentralSize = 46, kEndSize = 22, kEnd64Size = 56, kLocator64Size = 20;
constexpr std::uint32_t kWide = 0xffffffff;

class DirectoryReader {
  public:
    DirectoryReader(std::span<const std::byte> archive, const ZipLimits& limits, const ReadJob& job)
        : archive_(archive), limits_(limits), job_(job) {}

    std::vector<ZipEntry> read() {
        findDirectory();
        for (std::uint64_t i = 0; i < count_; ++i) readEntry();
        checkOverlaps();
        return std::move(entries_);
    }

  private:
    template <class Number>
    Number at(std::uint64_t offset) const {
        return load<Number>(archive_.data() + offset);
    }
    bool has(std::uint64_t offset, std::uint64_t bytes) const {
        return offset <= archive_.size() && bytes <= archive_.size() - offset;
    }

    void findDirectory() {
        if (archive_.size() < kEndSize) job_.refuseByte(0, "this is no zip archive", "a zip archive");
        std::uint64_t end = archive_.size() - kEndSize;
        const std::uint64_t last = end > 65535 ? end - 65535 : 0;
        while (at<std::uint32_t>(end) != kEnd) {
            if (end == last)
                job_.refuseByte(archive_.size(), "the zip archive has no directory at its end",
                                "a whole zip archive");
            --end;
        }
        if (at<std::uint16_t>(end + 4) != at<std::uint16_t>(end + 6))
            job_.refuseByte(end, "the zip archive is split over several files", "one file");
        count_ = at<std::uint16_t>(end + 10);
        size_ = at<std::uint32_t>(end + 12);
        next_ = at<std::uint32_t>(end + 16);
        if (count_ == 0xffff || size_ == kWide || next_ == kWide) readWideEnd(end);
        if (!has(next_, size_) || next_ + size_ > end || count_ > size_ / kCentralSize)
            job_.refuseByte(end, "the directory of the zip archive lies outside of it",
                            "a whole zip archive");
        if (count_ > limits_.entries)
            job_.refuseByte(end, "the zip archive holds " + std::to_string(count_) + " files",
                            "at most " + std::to_string(limits_.entries));
        stop_ = next_ + size_;
    }

    void readWideEnd(std::uint64_t end) {
        if (end < kLocator64Size || at<std::uint32_t>(end - kLocator64Size) != kLocator64) return;
        const auto wide = at<std::uint64_t>(end - kLocator64Size + 8);
        if (!has(wide, kEnd64Size) || at<std::uint32_t>(wide) != kEnd64)
            job_.refuseByte(end - kLocator64Size, "the zip64 directory is not where the archive says",
                            "a whole zip archive");
        count_ = at<std::uint64_t>(wide + 32);
        size_ = at<std::uint64_t>(wide + 40);
        next_ = at<std::uint64_t>(wide + 48);
    }

    void readEntry() {
        const std::uint64_t here = next_;
        if (here + kCentralSize > stop_ || at<std::uint32_t>(here) != kCentral)
            job_.refuseByte(here, "an entry of the zip directory is broken", "a whole zip archive");
        const auto nameLength = at<std::uint16_t>(here + 28);
        const auto extraLength = at<std::uint16_t>(here + 30);
        next_ = here + kCentralSize + nameLength + extraLength + at<std::uint16_t>(here + 32);
        if (next_ > stop_)
            job_.refuseByte(here, "an entry of the zip directory is broken", "a whole zip archive");
        ZipEntry entry;
        entry.name.assign(reinterpret_cast<const char*>(archive_.data() + here + kCentralSize), nameLength);
        entry.crc = at<std::uint32_t>(here + 16);
        entry.compressed = at<std::uint32_t>(here + 20);
        entry.size = at<std::uint32_t>(here + 24);
        std::uint64_t local = at<std::uint32_t>(here + 42);
        readWideSizes(here + kCentralSize + nameLength, extraLength, entry, local);
        checkName(here, entry.name);
        const auto flags = at<std::uint16_t>(here + 8);
        const auto method = at<std::uint16_t>(here + 10);
        if ((flags & 1) != 0 || (method != 0 && method != 8))
            job_.refuseByte(here, "'" + entry.name + "' in the archive is encrypted or packed in a rare way",
                            "stored or deflated files");
        entry.deflated = method == 8;
        locate(here, local, entry);
        if (!entry.deflated && entry.size != entry.compressed)
            job_.refuseByte(here, "the sizes of '" + entry.name + "' contradict each other",
                            "a stored file of one size");
        total_ += entry.size;
        if (entry.size > most() || total_ > most())
            job_.refuseByte(
                here, "the files in the archive are together more than " + std::to_string(most()) + " bytes",
                "no more than that for an archive of this size");
        if (!entry.name.ends_with('/')) entries_.push_back(std::move(entry));
    }

    std::uint64_t most() const { return std::max(limits_.freeBytes, limits_.ratio * archive_.size()); }

    /// The zip64 field holds, in this order, those numbers that the entry itself has no room for.
    void readWideSizes(std::uint64_t extra, std::uint64_t length, ZipEntry& entry,
                       std::uint64_t& local) const {
        const std::uint64_t stop = extra + length;
        while (extra + 4 <= stop) {
            const auto id = at<std::uint16_t>(extra);
            const std::uint64_t end = std::min<std::uint64_t>(stop, extra + 4 + at<std::uint16_t>(extra + 2));
            extra += 4;
            if (id == 1)
                for (std::uint64_t* number : {&entry.size, &entry.compressed, &local})
                    if (*number == kWide && extra + 8 <= end) {
                        *number = at<std::uint64_t>(extra);
                        extra += 8;
                    }
            extra = end;
        }
    }

    void checkName(std::uint64_t here, const std::string& name) {
        bool climbs = false;
        for (std::size_t from = 0; from <= name.size();) {
            const std::size_t to = std::min(name.find('/', from), name.size());
            climbs = climbs || std::string_view(name).substr(from, to - from) == "..";
            from = to + 1;
        }
        if (name.empty() || name.starts_with('/') || climbs || name.find('\\') != std::string::npos ||
            name.find('\0') != std::string::npos || (name.size() > 1 && name[1] == ':'))
            job_.refuseByte(here, "a file in the archive has a name that leads out of it",
                            "names below the archive's root");
        if (!names_.insert(name).second)
            job_.refuseByte(here, "the archive holds '" + name + "' twice", "every file once");
    }

    void locate(std::uint64_t here, std::uint64_t local, ZipEntry& entry) const {
        if (!has(local, kLocalSize) || at<std::uint32_t>(local) != kLocal)
            job_.refuseByte(here, "'" + entry.name + "' is not where the archive says",
                            "a whole zip archive");
        const auto nameLength = at<std::uint16_t>(local + 26);
        entry.data = local + kLocalSize + nameLength + at<std::uint16_t>(local + 28);
        const std::string_view name(reinterpret_cast<const char*>(archive_.data() + local + kLocalSize),
                                    has(local + kLocalSize, nameLength) ? nameLength : 0);
        if (!has(entry.data, entry.compressed) || name != entry.name)
            job_.refuseByte(local, "'" + entry.name + "' does not fit what the archive's directory says",
                            "a whole zip archive");
    }

    /// Entries that share their bytes are how small archives become endless ones.
    void checkOverlaps() const {
        std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
        for (const ZipEntry& entry : entries_)
            ranges.emplace_back(entry.data - kLocalSize - entry.name.size(), entry.data + entry.compressed);
        std::sort(ranges.begin(), ranges.end());
        for (std::size_t i = 1; i < ranges.size(); ++i)
            if (ranges[i].first < ranges[i - 1].second)
                job_.refuseByte(ranges[i].first, "files in the archive overlap",
                                "every file in a place of its own");
    }

    std::span<const std::byte> archive_;
    const ZipLimits& limits_;
    const ReadJob& job_;
    std::vector<ZipEntry> entries_;
    std::set<std::string> names_;
    std::uint64_t count_ = 0, size_ = 0, next_ = 0, stop_ = 0, total_ = 0;
};

}  // namespace

std::vector<ZipEntry> readZipDirectory(std::span<const std::byte> archive, const ZipLimits& limits,
                                       const ReadJob& job) {
    return DirectoryReader(archive, limits, job).read();
}

}  // namespace vestige
