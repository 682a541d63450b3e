#include "core/io/formats/LazCheck.h"

#include <algorithm>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr std::size_t kRecordHeader = 54;
constexpr std::size_t kFixedPart = 34;  // of LASzip's record, before its items
constexpr std::size_t kItemSize = 6;
constexpr std::size_t kChunkTableHeader = 8;

const LasRecord* lazRecord(const LasHeader& header) {
    return header.find("laszip encoded", 22204);
}

std::size_t placeOf(std::span<const std::byte> file, const LasRecord& record) {
    return static_cast<std::size_t>(record.content.data() - file.data());
}

/// Sizes by item type: 0 bytes, 6 point10, 7 gps time, 8 rgb, 9 and 13 wave packet, 10 point14, 11 rgb, 12
/// rgb and near infrared, 14 bytes; 0 where the record says it.
bool itemIsKnown(std::uint16_t type, std::uint16_t size, std::uint16_t version) {
    if (version > 4) return false;
    switch (type) {
        case 0:
        case 14:
            return size > 0;
        case 6:
            return size == 20;
        case 7:
            return size == 8;
        case 8:
        case 11:
            return size == 6;
        case 9:
        case 13:
            return size == 29;
        case 10:
            return size == 30;
        case 12:
            return size == 8;
        default:
            return false;
    }
}

void checkItems(std::span<const std::byte> file, const LasHeader& header, const LasRecord& record,
                const ReadJob& job) {
    const std::size_t place = placeOf(file, record);
    const auto items = load<std::uint16_t>(record.content.data() + 32);
    if (items == 0 || items > (record.content.size() - kFixedPart) / kItemSize)
        job.refuseByte(place + 32, "LASzip's record promises " + counted(items, "item"),
                       "as many as it has room for");
    std::size_t total = 0;
    for (std::size_t i = 0; i < items; ++i) {
        const std::byte* item = record.content.data() + kFixedPart + kItemSize * i;
        const auto size = load<std::uint16_t>(item + 2);
        if (!itemIsKnown(load<std::uint16_t>(item), size, load<std::uint16_t>(item + 4)))
            job.refuseByte(place + kFixedPart + kItemSize * i, "LASzip's record has an item of unknown kind",
                           "the items of LASzip 1 to 4");
        total += size;
    }
    if (total != header.recordLength)
        job.refuseByte(place + kFixedPart, "LASzip's items have " + counted(total, "byte"),
                       std::to_string(header.recordLength) + " as a point has by the header");
}

void checkChunkTable(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job) {
    const std::size_t begin = header.pointOffset;
    if (file.size() - begin < 8)
        job.refuseByte(begin, "the file ends before the compressed points", "8 bytes or more");
    auto table = load<std::int64_t>(file.data() + begin);
    // A writer that cannot go back leaves -1 here and the place at the end of the file.
    if (table == -1) table = load<std::int64_t>(file.data() + file.size() - 8);
    const auto last = static_cast<std::int64_t>(file.size() - kChunkTableHeader);
    if (table < static_cast<std::int64_t>(begin) + 8 || table > last)
        job.refuseByte(begin, "the chunk table is said to be at byte " + std::to_string(table),
                       "a place behind the points and inside the file: is the file cut off?");
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
}

}  // namespace

void checkLaz(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job) {
    const LasRecord* record = lazRecord(header);
    if (!record || record->content.size() < kFixedPart + kItemSize || record->content.size() > 65535)
        job.refuseByte(header.headerSize, "a compressed file without a whole record of LASzip",
                       "the record 'laszip encoded' 22204");
    const std::size_t place = placeOf(file, *record);
    const auto compressor = load<std::uint16_t>(record->content.data());
    const auto coder = load<std::uint16_t>(record->content.data() + 2);
    if (compressor < 1 || compressor > 3 || coder != 0)
        job.refuseByte(place, "LASzip's record names an unknown compressor", "1, 2 or 3, and coder 0");
    const auto chunkSize = load<std::uint32_t>(record->content.data() + 12);
    if (compressor != 1 && chunkSize == 0)
        job.refuseByte(place + 12, "LASzip's record names chunks of no points", "a chunk size such as 50000");
    checkItems(file, header, *record, job);
    if (compressor != 1) checkChunkTable(file, header, job);
}

std::vector<std::byte> lazPrefix(std::span<const std::byte> file, const LasHeader& header) {
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
    return prefix;
}

}  // namespace vestige
