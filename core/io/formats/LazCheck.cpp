#include "core/io/formats/LazCheck.h"

#include <algorithm>
#include <array>

#include "core/io/Bytes.h"
#include "core/io/formats/PatchedBuffer.h"

namespace vestige {
namespace {

constexpr std::size_t kRecordHeader = 54;
constexpr std::size_t kFixedPart = 34;  // of LASzip's record, before its items
constexpr std::size_t kItemSize = 6;
constexpr std::size_t kChunkTableHeader = 8;
constexpr std::uint32_t kVariableChunks = 0xffffffff;
constexpr std::uint64_t kTypicalChunk = 50000;

const LasRecord* lazRecord(const LasHeader& header) {
    return header.find("laszip encoded", 22204);
}

std::size_t placeOf(std::span<const std::byte> file, const LasRecord& record) {
    return static_cast<std::size_t>(record.content.data() - file.data());
}

struct Item {
    std::uint16_t type;
    std::uint16_t size;
};

/// The items that make up a point (LASzip's numbers): 6 point, 7 GPS time, 8 colour, 9 wave packet; since
/// format 6 10 point, 11 colour, 12 colour and infrared, 13 wave packet; 0 and 14 extra bytes.
std::vector<Item> expectedItems(const LasHeader& header) {
    static const std::array<std::vector<Item>, 11> kItems{{{{6, 20}},
                                                           {{6, 20}, {7, 8}},
                                                           {{6, 20}, {8, 6}},
                                                           {{6, 20}, {7, 8}, {8, 6}},
                                                           {{6, 20}, {7, 8}, {9, 29}},
                                                           {{6, 20}, {7, 8}, {8, 6}, {9, 29}},
                                                           {{10, 30}},
                                                           {{10, 30}, {11, 6}},
                                                           {{10, 30}, {12, 8}},
                                                           {{10, 30}, {13, 29}},
                                                           {{10, 30}, {12, 8}, {13, 29}}}};
    const LasPointLayout& layout = lasPointLayout(header.pointFormat);
    std::vector<Item> items = kItems.at(static_cast<std::size_t>(header.pointFormat));
    if (header.recordLength > layout.size)
        items.push_back({static_cast<std::uint16_t>(layout.extended ? 14 : 0),
                         static_cast<std::uint16_t>(header.recordLength - layout.size)});
    return items;
}

/// The versions of LASzip's item coders: 1 and 2 point by point, 2 to 4 in layers; wave packets only in some.
bool versionIsKnown(const Item& item, std::uint16_t version, bool layered) {
    if (item.type == 9) return version == 1;
    return layered ? version >= 2 && version <= 4 : version == 1 || version == 2;
}

void checkItems(std::span<const std::byte> file, const LasHeader& header, const LasRecord& record,
                bool layered, const ReadJob& job) {
    const std::size_t place = placeOf(file, record) + kFixedPart;
    const std::vector<Item> expected = expectedItems(header);
    const auto items = load<std::uint16_t>(record.content.data() + 32);
    if (items != expected.size() || record.content.size() < kFixedPart + kItemSize * items ||
        layered != lasPointLayout(header.pointFormat).extended)
        job.refuseByte(
            place - 2, "LASzip's record has " + counted(items, "item"),
            std::to_string(expected.size()) + " for point format " + std::to_string(header.pointFormat));
    for (std::size_t i = 0; i < items; ++i) {
        const std::byte* item = record.content.data() + kFixedPart + kItemSize * i;
        if (load<std::uint16_t>(item) != expected[i].type ||
            load<std::uint16_t>(item + 2) != expected[i].size ||
            !versionIsKnown(expected[i], load<std::uint16_t>(item + 4), layered))
            job.refuseByte(place + kItemSize * i, "LASzip's record does not describe points of this format",
                           "item " + std::to_string(expected[i].type) + " of " +
                               std::to_string(expected[i].size) + " bytes");
    }
}

/// The layered chunks must fill the place up to the chunk table exactly.
laz::WholeChunks checkLayers(std::span<const std::byte> file, const LasHeader& header, std::size_t table,
                             const ReadJob& job) {
    laz::WholeChunks whole = laz::wholeChunks(file, header, table);
    if (whole.end != table)
        job.refuseByte(
            whole.end,
            "a chunk of compressed points does not fit into the file, or holds what no encoder writes",
            "chunks that fill the bytes up to the chunk table");
    if (whole.points != header.points)
        job.refuseByte(header.pointOffset, "the chunks hold " + std::to_string(whole.points) + " points",
                       std::to_string(header.points) + " as the header says");
    return whole;
}

/// Whether LayeredChunk reads points of this format and version.
bool isOurs(const LasHeader& header, const LasRecord& record) {
    const auto version = load<std::uint16_t>(record.content.data() + kFixedPart + 4);
    if (header.pointFormat < 6 || header.pointFormat > 8 || (version != 3 && version != 4)) return false;
    return header.pointFormat == 6 ||
           load<std::uint16_t>(record.content.data() + kFixedPart + kItemSize + 4) == version;
}

/// Arithmetic coding packs equal points into next to nothing, so a short file could ask for any amount of
/// memory. Scans are packed to a fifth or a tenth; a header that promises a thousand times is none of a scan.
void checkPromise(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job) {
    constexpr std::uint64_t kAlwaysFine = std::uint64_t{1} << 20;
    constexpr std::uint64_t kMostGrowth = 1000;
    const std::uint64_t most = kMostGrowth * (file.size() - header.pointOffset) / header.recordLength;
    if (header.points > std::max(kAlwaysFine, most))
        job.refuseByte(header.versionMinor >= 4 ? 247 : 107,
                       "the header promises " + std::to_string(header.points) +
                           " points, more than the compressed bytes of any scan hold",
                       std::to_string(std::max(kAlwaysFine, most)) + " at most");
}

/// The place of the chunk table.
std::size_t checkChunkTable(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job) {
    const std::size_t begin = header.pointOffset;
    if (file.size() - begin < 8)
        job.refuseByte(begin, "the file ends before the compressed points", "8 bytes or more");
    auto table = load<std::int64_t>(file.data() + begin);
    // A writer that cannot go back leaves -1 here and the place at the end of the file.
    if (table == -1) table = load<std::int64_t>(file.data() + file.size() - 8);
    const auto last = static_cast<std::int64_t>(file.size() - kChunkTableHeader);
    if (table < static_cast<std::int64_t>(begin) + 8 || table > last)
        job.refuseByte(begin, "the chunk table is said to be at byte " + std::to_string(table),
                       "a place behind the points and inside the file");
    const auto place = static_cast<std::size_t>(table);
    const auto version = load<std::uint32_t>(file.data() + place);
    const auto chunks = load<std::uint32_t>(file.data() + place + 4);
    // Each chunk begins with one whole point.
    const std::size_t most = (place - begin - 8) / lasPointLayout(header.pointFormat).size;
    if (version != 0 || chunks > most)
        job.refuseByte(place, "the chunk table promises " + counted(chunks, "chunk"),
                       "version 0 and " + std::to_string(most) + " chunks at most");
    if (chunks == 0 && header.points > 0)
        job.refuseByte(place, "the chunk table has no chunks", "some for " + counted(header.points, "point"));
    return place;
}

}  // namespace

LazPlan planLaz(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job, bool salvage) {
    const LasRecord* record = lazRecord(header);
    if (!record || record->content.size() < kFixedPart + kItemSize || record->content.size() > 65535)
        job.refuseByte(header.headerSize, "a compressed file without a whole record of LASzip",
                       "the record 'laszip encoded' 22204");
    checkPromise(file, header, job);
    const std::size_t place = placeOf(file, *record);
    const auto compressor = load<std::uint16_t>(record->content.data());
    const auto coder = load<std::uint16_t>(record->content.data() + 2);
    if (compressor < 1 || compressor > 3 || coder != 0)
        job.refuseByte(place, "LASzip's record names an unknown compressor", "1, 2 or 3, and coder 0");
    const auto chunkSize = load<std::uint32_t>(record->content.data() + 12);
    if (compressor != 1 && chunkSize == 0)
        job.refuseByte(place + 12, "LASzip's record names chunks of no points", "a chunk size such as 50000");
    const bool layered = compressor == 3;
    checkItems(file, header, *record, layered, job);
    LazPlan plan;
    plan.points = header.points;
    // A code that is not below its range leads LASzip's decoder out of its tables. It begins at four places:
    // behind the point that each chunk begins with, at the chunk table's entries (PatchedBuffer looks at
    // both) and, in layers, at each layer (wholeChunks).
    if (layered) plan.asVersion3 = load<std::uint16_t>(record->content.data() + kFixedPart + 4) == 3;
    if (compressor == 1) return plan;
    plan.variableChunks = chunkSize == kVariableChunks;
    plan.chunkSize = plan.variableChunks ? kTypicalChunk : chunkSize;
    plan.sureTogether = plan.variableChunks ? 0 : chunkSize;
    try {
        const std::size_t table = checkChunkTable(file, header, job);
        if (layered) {
            laz::WholeChunks whole = checkLayers(file, header, table, job);
            if (isOurs(header, *record) && laz::countsFit(whole, plan.sureTogether) &&
                laz::tableAgrees(file.subspan(table), whole, plan.variableChunks))
                plan.chunks = std::move(whole.chunks);
        }
    } catch (const ErrorException&) {
        if (!salvage || plan.variableChunks || file.size() - header.pointOffset < 8) throw;
        plan.withoutTable = true;
        plan.chunkSize = 0;
        if (!layered) return plan;
        laz::WholeChunks whole = laz::wholeChunks(file, header, file.size());
        plan.points = std::min(header.points, whole.points);
        if (isOurs(header, *record) && laz::countsFit(whole, plan.sureTogether))
            plan.chunks = std::move(whole.chunks);
    }
    return plan;
}

std::vector<std::byte> lazPrefix(std::span<const std::byte> file, const LasHeader& header,
                                 const LazPlan& plan) {
    std::vector<std::byte> prefix(header.pointOffset);
    std::copy_n(file.begin(), header.headerSize, prefix.begin());
    const LasRecord& record = *lazRecord(header);
    store<std::uint32_t>(prefix.data() + 100, 1);
    if (header.versionMinor >= 4) {
        store<std::uint64_t>(prefix.data() + 235, 0);
        store<std::uint32_t>(prefix.data() + 243, 0);
        store<std::uint64_t>(prefix.data() + 247, header.points);
    }
    const std::byte* source = record.content.data() - kRecordHeader;
    std::copy_n(source, kRecordHeader + record.content.size(), prefix.data() + header.headerSize);
    if (plan.withoutTable) {
        // LASzip's own mark of a writer that did not come to its chunk table: the table's place is the first
        // chunk's.
        prefix.resize(header.pointOffset + 8);
        store<std::int64_t>(prefix.data() + header.pointOffset,
                            static_cast<std::int64_t>(header.pointOffset));
    }
    return prefix;
}

}  // namespace vestige
