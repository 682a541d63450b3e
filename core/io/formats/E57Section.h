#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/io/formats/E57Columns.h"

namespace vestige {

/// The CompressedVector section of a scan to write: its header, data packets of 64 KiB that all hold the same
/// number of records, so that every packet begins with a whole byte of every stream, and one index packet.
class E57Section {
  public:
    /// `begin` (logical) is where the section will stand. The part must outlive it.
    E57Section(const E57Part& part, std::uint64_t begin);

    std::uint64_t begin() const { return begin_; }
    std::uint64_t end() const { return begin_ + length(); }
    /// Hands out the section piece by piece; `step` is told how many records are done.
    void write(const std::function<void(std::span<const std::byte>)>& out,
               const std::function<void(std::size_t)>& step) const;

  private:
    std::uint64_t records() const { return part_.points; }
    std::uint64_t packets() const { return (records() + perPacket_ - 1) / perPacket_; }
    std::uint64_t packetLength(std::uint64_t records) const;
    std::uint64_t packetOffset(std::uint64_t packet) const;
    std::uint64_t indexOffset() const;
    std::uint64_t length() const;
    std::vector<std::byte> header() const;
    std::vector<std::byte> packet(std::uint64_t number) const;
    std::vector<std::byte> index() const;

    const E57Part& part_;
    std::uint64_t begin_;
    std::uint64_t perPacket_;
    std::uint64_t indexEvery_;
};

}  // namespace vestige
