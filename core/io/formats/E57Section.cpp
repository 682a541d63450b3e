#include "core/io/formats/E57Section.h"

#include <algorithm>

#include "core/base/Parallel.h"
#include "core/io/Bytes.h"
#include "core/io/formats/E57Bits.h"
#include "core/io/formats/E57PageWriter.h"

namespace vestige {
namespace {

constexpr std::uint64_t kHeader = 32;
constexpr std::uint64_t kPacketHeader = 6;
constexpr std::uint64_t kLargestPacket = 65536;
constexpr std::uint64_t kIndexHeader = 16;
constexpr std::uint64_t kIndexEntry = 16;
constexpr std::uint64_t kMostEntries = 2048;
/// Streams of so many records are whole 64-bit words, whatever the bits of a value.
constexpr std::uint64_t kAligned = 64;
/// Packets that are made in parallel before they are handed out in their order.
constexpr std::uint64_t kTogether = 32;

std::uint64_t upTo(std::uint64_t size, std::uint64_t unit) {
    return (size + unit - 1) / unit * unit;
}

/// Some readers take integers out of words of 8, 16, 32 or 64 bits, so a stream ends with a whole one.
std::uint64_t streamBytes(std::uint64_t records, unsigned bits) {
    const std::uint64_t word = bits <= 8 ? 1 : bits <= 16 ? 2 : bits <= 32 ? 4 : 8;
    return upTo((records * bits + 7) / 8, word);
}

}  // namespace

E57Section::E57Section(const E57Part& part, std::uint64_t begin) : part_(part), begin_(begin) {
    std::uint64_t bits = 0;
    for (const E57Column& column : part.columns) bits += column.bits;
    const std::uint64_t room = kLargestPacket - kPacketHeader - 2 * part.columns.size() - 3;
    perPacket_ = 8 * room / bits / kAligned * kAligned;
    indexEvery_ = (packets() + kMostEntries - 1) / kMostEntries;
}

std::uint64_t E57Section::packetLength(std::uint64_t records) const {
    std::uint64_t bytes = kPacketHeader + 2 * part_.columns.size();
    for (const E57Column& column : part_.columns) bytes += streamBytes(records, column.bits);
    return upTo(bytes, 4);
}

std::uint64_t E57Section::packetOffset(std::uint64_t packet) const {
    return begin_ + kHeader + packet * packetLength(perPacket_);
}

std::uint64_t E57Section::indexOffset() const {
    if (records() == 0) return packetOffset(0);
    const std::uint64_t last = packets() - 1;
    return packetOffset(last) + packetLength(records() - last * perPacket_);
}

std::uint64_t E57Section::length() const {
    if (records() == 0) return kHeader;
    return indexOffset() - begin_ + index().size();
}

void E57Section::write(const std::function<void(std::span<const std::byte>)>& out,
                       const std::function<void(std::size_t)>& step) const {
    out(header());
    std::vector<std::vector<std::byte>> made(kTogether);
    for (std::uint64_t first = 0; first < packets(); first += kTogether) {
        step(first * perPacket_);
        const std::uint64_t count = std::min(kTogether, packets() - first);
        parallelChunks(count, 1, [&](std::size_t chunk, std::size_t, std::size_t) {
            made[chunk] = packet(first + chunk);
        });
        for (std::size_t i = 0; i < count; ++i) out(made[i]);
    }
    if (records() > 0) out(index());
}

std::vector<std::byte> E57Section::header() const {
    std::vector<std::byte> bytes(kHeader);
    bytes[0] = std::byte{1};
    store<std::uint64_t>(bytes.data() + 8, length());
    store<std::uint64_t>(bytes.data() + 16, E57PageWriter::physical(packetOffset(0)));
    if (records() > 0) store<std::uint64_t>(bytes.data() + 24, E57PageWriter::physical(indexOffset()));
    return bytes;
}

std::vector<std::byte> E57Section::packet(std::uint64_t number) const {
    const std::uint64_t first = number * perPacket_;
    const std::uint64_t count = std::min(perPacket_, records() - first);
    std::vector<std::byte> bytes(packetLength(count));
    bytes[0] = std::byte{1};
    store<std::uint16_t>(bytes.data() + 2, static_cast<std::uint16_t>(bytes.size() - 1));
    store<std::uint16_t>(bytes.data() + 4, static_cast<std::uint16_t>(part_.columns.size()));
    std::size_t table = kPacketHeader;
    std::size_t at = kPacketHeader + 2 * part_.columns.size();
    for (const E57Column& column : part_.columns) {
        E57BitWriter writer;
        for (std::uint64_t i = 0; i < count; ++i)
            writer.put(column.raw(part_.member(first + i)), column.bits);
        const std::vector<std::byte> stream = writer.take(true);
        std::copy(stream.begin(), stream.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
        const std::uint64_t length = streamBytes(count, column.bits);
        store<std::uint16_t>(bytes.data() + table, static_cast<std::uint16_t>(length));
        table += 2;
        at += length;
    }
    return bytes;
}

std::vector<std::byte> E57Section::index() const {
    const std::uint64_t entries = (packets() + indexEvery_ - 1) / indexEvery_;
    std::vector<std::byte> bytes(kIndexHeader + kIndexEntry * entries);
    store<std::uint16_t>(bytes.data() + 2, static_cast<std::uint16_t>(bytes.size() - 1));
    store<std::uint16_t>(bytes.data() + 4, static_cast<std::uint16_t>(entries));
    for (std::uint64_t entry = 0; entry < entries; ++entry) {
        std::byte* at = bytes.data() + kIndexHeader + kIndexEntry * entry;
        store<std::uint64_t>(at, entry * indexEvery_ * perPacket_);
        store<std::uint64_t>(at + 8, E57PageWriter::physical(packetOffset(entry * indexEvery_)));
    }
    return bytes;
}

}  // namespace vestige
