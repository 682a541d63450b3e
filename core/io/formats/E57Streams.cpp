#include "core/io/formats/E57Streams.h"

#include <algorithm>
#include <array>

#include "core/io/Bytes.h"
#include "core/io/formats/E57Bits.h"

namespace vestige {
namespace {

constexpr std::uint64_t kSectionHeader = 32;
constexpr std::uint64_t kPacketHeader = 6;
constexpr std::uint64_t kSmallestPacket = 4;
/// Kinds of packet (ASTM E2807, 9.3): index, data, ignored.
constexpr std::byte kData{1};
constexpr std::byte kIgnored{2};

std::uint64_t bytesOf(std::uint64_t records, unsigned bits) {
    return (records * bits + 7) / 8;
}

}  // namespace

E57Streams::E57Streams(const E57Pages& pages, const E57Scan& scan, bool salvage, const ReadJob& job)
    : pages_(pages), scan_(scan), streams_(scan.fields.size()) {
    try {
        walk(job);
    } catch (const ErrorException& problem) {
        if (!salvage || problem.error.code != ErrorCode::input) throw;
        damage_ = problem.error.message + " (" + problem.error.place + ")";
    }
    records_ = wholeRecords();
}

void E57Streams::walk(const ReadJob& job) {
    std::uint64_t end = 0;
    std::uint64_t at = dataOffset(job, end);
    std::size_t packets = 0;
    while (!complete()) {
        if (at >= end)
            job.refuseByte(pages_.physical(at),
                           "the scan ends after " + std::to_string(wholeRecords()) + " of " +
                               counted(scan_.records, "point"),
                           "as many points as its XML promises");
        at += addPacket(at, end, job);
        walked_ = at - scan_.section;
        job.step(++packets, 0);
    }
}

std::uint64_t E57Streams::dataOffset(const ReadJob& job, std::uint64_t& end) const {
    const std::size_t byte = pages_.physical(scan_.section);
    if (pages_.logicalSize() - scan_.section < kSectionHeader ||
        pages_.damaged(scan_.section, kSectionHeader))
        job.refuseByte(byte, "the header of the scan's section is cut off or damaged", "32 bytes");
    std::array<std::byte, kSectionHeader> header{};
    pages_.copy(scan_.section, header);
    if (header[0] != std::byte{1})
        job.refuseByte(byte, "the section of a scan is of another kind", "a CompressedVector section (1)");
    const auto length = load<std::uint64_t>(header.data() + 8);
    if (length < kSectionHeader || length > pages_.logicalSize() - scan_.section)
        job.refuseByte(byte + 8, "a section of " + counted(length, "byte") + " does not fit into the file",
                       "32 to " + std::to_string(pages_.logicalSize() - scan_.section));
    end = scan_.section + length;
    if (complete()) return end;
    const std::uint64_t data =
        pages_.logical(load<std::uint64_t>(header.data() + 16), "the scan's data", byte + 16, job);
    if (data < scan_.section + kSectionHeader || data > end)
        job.refuseByte(byte + 16, "the scan's data begin outside of its section", "a byte within it");
    return data;
}

bool E57Streams::complete() const {
    for (std::size_t i = 0; i < streams_.size(); ++i)
        if (scan_.fields[i].role != E57Role::none &&
            streams_[i].bytes < bytesOf(scan_.records, scan_.fields[i].bits))
            return false;
    return true;
}

std::uint64_t E57Streams::wholeRecords() const {
    std::uint64_t records = scan_.records;
    for (std::size_t i = 0; i < streams_.size(); ++i)
        if (scan_.fields[i].role != E57Role::none && scan_.fields[i].bits > 0)
            records = std::min(records, 8 * streams_[i].bytes / scan_.fields[i].bits);
    return records;
}

std::uint64_t E57Streams::addPacket(std::uint64_t at, std::uint64_t end, const ReadJob& job) {
    const std::size_t byte = pages_.physical(at);
    if (end - at < kSmallestPacket)
        job.refuseByte(byte, "the section ends inside a packet", "a whole packet");
    if (pages_.damaged(at, kSmallestPacket)) job.refuseByte(byte, "a packet is damaged", "whole pages");
    std::array<std::byte, kSmallestPacket> header{};
    pages_.copy(at, header);
    const std::uint64_t length = load<std::uint16_t>(header.data() + 2) + std::uint64_t{1};
    if (header[0] > kIgnored)
        job.refuseByte(byte, "a packet of unknown kind " + std::to_string(std::to_integer<int>(header[0])),
                       "an index, data or ignored packet (0, 1, 2)");
    if (length % 4 != 0 || length > end - at)
        job.refuseByte(byte + 2, "a packet of " + counted(length, "byte") + " does not fit into its section",
                       "a multiple of 4, " + std::to_string(end - at) + " at most");
    if (header[0] == kData) addPieces(at, length, job);
    return length;
}

void E57Streams::addPieces(std::uint64_t at, std::uint64_t length, const ReadJob& job) {
    const std::size_t byte = pages_.physical(at);
    const std::size_t table = kPacketHeader + 2 * streams_.size();
    if (length < table) job.refuseByte(byte + 2, "a packet is too short for its table", "more bytes");
    if (pages_.damaged(at, length)) job.refuseByte(byte, "a packet is damaged", "whole pages");
    std::vector<std::byte> header(table);
    pages_.copy(at, header);
    const auto count = load<std::uint16_t>(header.data() + 4);
    if (count != streams_.size())
        job.refuseByte(byte + 4, "a packet has " + counted(count, "byte stream"),
                       std::to_string(streams_.size()) + ", as many as the prototype has fields");
    std::uint64_t total = table;
    for (std::size_t i = 0; i < count; ++i)
        total += load<std::uint16_t>(header.data() + kPacketHeader + 2 * i);
    if (total > length)
        job.refuseByte(byte + kPacketHeader, "the byte streams of a packet are longer than it",
                       counted(length - table, "byte") + " at most");
    std::uint64_t place = at + table;
    for (std::size_t i = 0; i < count; ++i) {
        const auto bytes = load<std::uint16_t>(header.data() + kPacketHeader + 2 * i);
        // A stream that is complete grows no further, so that its pieces are no more than its bytes.
        if (bytes > 0 && scan_.fields[i].role != E57Role::none &&
            streams_[i].bytes < bytesOf(scan_.records, scan_.fields[i].bits)) {
            streams_[i].pieces.push_back({streams_[i].bytes, place});
            streams_[i].bytes += bytes;
        }
        place += bytes;
    }
}

template <class Visit>
void E57Streams::visit(std::size_t field, std::uint64_t first, std::uint64_t count,
                       const Visit& piece) const {
    const Stream& stream = streams_[field];
    auto at = std::upper_bound(stream.pieces.begin(), stream.pieces.end(), first,
                               [](std::uint64_t byte, const Piece& each) { return byte < each.first; });
    for (--at; count > 0; ++at) {
        const std::uint64_t pieceEnd = at + 1 == stream.pieces.end() ? stream.bytes : (at + 1)->first;
        const std::uint64_t bytes = std::min(count, pieceEnd - first);
        piece(at->logical + (first - at->first), bytes);
        first += bytes;
        count -= bytes;
    }
}

void E57Streams::decode(std::size_t field, std::uint64_t first, std::span<double> values,
                        std::vector<std::byte>& bytes) const {
    const E57Field& kind = scan_.fields[field];
    const std::uint64_t begin = first * kind.bits / 8;
    const std::uint64_t count = bytesOf(first + values.size(), kind.bits) - begin;
    bytes.resize(count + kReadAhead);
    std::byte* to = bytes.data();
    if (count > 0)
        visit(field, begin, count, [&](std::uint64_t logical, std::uint64_t length) {
            pages_.copy(logical, {to, length});
            to += length;
        });
    decodeE57(kind, bytes.data(), static_cast<unsigned>(first * kind.bits % 8), values);
}

void E57Streams::check(std::size_t field, std::uint64_t first, std::uint64_t count,
                       const ReadJob& job) const {
    const unsigned bits = scan_.fields[field].bits;
    if (count == 0 || bits == 0) return;
    const std::uint64_t begin = first * bits / 8;
    visit(field, begin, bytesOf(first + count, bits) - begin,
          [&](std::uint64_t logical, std::uint64_t length) { pages_.check(logical, length, job); });
}

}  // namespace vestige
