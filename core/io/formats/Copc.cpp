#include "core/io/formats/Copc.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr std::size_t kInfoSize = 160;
constexpr std::size_t kEntrySize = 32;
constexpr int kDeepest = 31;

struct Entry {
    int level;
    Eigen::Vector3d cell;
    std::uint64_t offset;
    std::uint64_t points;
};

/// Reads the pages of the hierarchy, each once; false where they do not make sense.
class Hierarchy {
  public:
    explicit Hierarchy(std::span<const std::byte> file) : file_(file) {}

    bool read(std::uint64_t offset, std::uint64_t size) {
        pages_.push_back({offset, size});
        for (std::size_t page = 0; page < pages_.size(); ++page)
            if (!readPage(pages_[page].first, pages_[page].second)) return false;
        return true;
    }
    std::vector<Entry>& entries() { return entries_; }

  private:
    bool readPage(std::uint64_t offset, std::uint64_t size) {
        if (offset > file_.size() || size > file_.size() - offset || size % kEntrySize != 0) return false;
        // Pages do not overlap; those that did could ask for any amount of memory.
        if (size > file_.size() - read_) return false;
        read_ += size;
        if (!seen_.insert(offset).second) return false;
        for (std::uint64_t at = offset; at < offset + size; at += kEntrySize) {
            const std::byte* entry = file_.data() + at;
            const auto level = load<std::int32_t>(entry);
            const auto place = load<std::uint64_t>(entry + 16);
            const auto bytes = load<std::int32_t>(entry + 24);
            const auto points = load<std::int32_t>(entry + 28);
            if (level < 0 || level > kDeepest || bytes < 0 || points < -1) return false;
            if (points == -1) {
                pages_.emplace_back(place, static_cast<std::uint64_t>(bytes));
                continue;
            }
            if (points == 0) continue;
            entries_.push_back({level,
                                {static_cast<double>(load<std::int32_t>(entry + 4)),
                                 static_cast<double>(load<std::int32_t>(entry + 8)),
                                 static_cast<double>(load<std::int32_t>(entry + 12))},
                                place,
                                static_cast<std::uint64_t>(points)});
        }
        return true;
    }

    std::span<const std::byte> file_;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> pages_;
    std::unordered_set<std::uint64_t> seen_;
    std::uint64_t read_ = 0;
    std::vector<Entry> entries_;
};

void join(std::vector<LasRange>& ranges, const LasRange& next) {
    if (!ranges.empty() && ranges.back().end == next.begin)
        ranges.back().end = next.end;
    else
        ranges.push_back(next);
}

}  // namespace

std::optional<std::vector<CopcNode>> copcNodes(std::span<const std::byte> file, const LasHeader& header,
                                               ReadJob& job) {
    const LasRecord* info = header.find("copc", 1);
    if (!header.compressed || !info || info->content.size() < kInfoSize) return std::nullopt;
    const std::byte* at = info->content.data();
    const Eigen::Vector3d centre(load<double>(at), load<double>(at + 8), load<double>(at + 16));
    const auto half = load<double>(at + 24);
    Hierarchy hierarchy(file);
    bool sound = centre.allFinite() && std::isfinite(half) && half > 0 &&
                 hierarchy.read(load<std::uint64_t>(at + 40), load<std::uint64_t>(at + 48));
    // Every chunk is a node, so that the nodes in the order of their places are the points in the order of
    // the file.
    std::vector<Entry>& entries = hierarchy.entries();
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.offset < b.offset; });
    std::vector<CopcNode> nodes;
    std::uint64_t points = 0;
    for (std::size_t i = 0; i < entries.size() && sound; ++i) {
        const Entry& entry = entries[i];
        sound = i == 0 || entries[i - 1].offset < entry.offset;
        const double side = std::ldexp(2 * half, -entry.level);
        CopcNode& node = nodes.emplace_back();
        node.level = entry.level;
        node.box.min = (centre.array() - half).matrix() + side * entry.cell;
        node.box.max = (node.box.min.array() + side).matrix();
        node.points = {points, points + entry.points};
        points += entry.points;
    }
    if (sound && points == header.points) return nodes;
    job.warn(
        "the octree of the COPC file does not fit its points; they are read as those of a plain LAZ file");
    return std::nullopt;
}

std::vector<LasRange> rangesTouching(const std::vector<CopcNode>& nodes, const BoundingBox& box) {
    std::vector<LasRange> ranges;
    for (const CopcNode& node : nodes) {
        // A point on the face between two nodes may be in either; rounding may put it a hair outside its own.
        const double hair = 1e-6 * (node.box.max.x() - node.box.min.x());
        if ((node.box.min.array() - hair <= box.max.array()).all() &&
            (node.box.max.array() + hair >= box.min.array()).all())
            join(ranges, node.points);
    }
    return ranges;
}

std::vector<LasRange> coarseRanges(const std::vector<CopcNode>& nodes, std::uint64_t points) {
    std::vector<std::uint64_t> perLevel(kDeepest + 1, 0);
    for (const CopcNode& node : nodes) perLevel[static_cast<std::size_t>(node.level)] += node.points.size();
    int deepest = 0;
    std::uint64_t sum = perLevel[0];
    while (deepest < kDeepest && sum + perLevel[static_cast<std::size_t>(deepest) + 1] <= points)
        sum += perLevel[static_cast<std::size_t>(++deepest)];
    std::vector<LasRange> ranges;
    for (const CopcNode& node : nodes)
        if (node.level <= deepest) join(ranges, node.points);
    return ranges;
}

}  // namespace vestige
