#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/formats/E57Document.h"

namespace vestige {

/// Where the byte streams of a scan's fields lie: the packets of its CompressedVector section, walked once,
/// so that any records can be decoded on their own.
class E57Streams {
  public:
    /// Walks the packets until the fields that have a role are there for every record. Refuses a damaged
    /// section at its byte; with `salvage` it stops there, records() are those that are whole and damage()
    /// says what was met.
    E57Streams(const E57Pages& pages, const E57Scan& scan, bool salvage, const ReadJob& job);

    std::uint64_t records() const { return records_; }
    const std::string& damage() const { return damage_; }
    /// How many bytes of the section were walked.
    std::uint64_t walked() const { return walked_; }

    /// The values of a field for the records from `first` on, as many as `values` has room for. `bytes` is
    /// room to work in.
    void decode(std::size_t field, std::uint64_t first, std::span<double> values,
                std::vector<std::byte>& bytes) const;
    /// Refuses where a page that decode() would touch is damaged.
    void check(std::size_t field, std::uint64_t first, std::uint64_t count, const ReadJob& job) const;

  private:
    /// A piece of a stream in one packet: the number of its first byte in the stream, and where it lies.
    struct Piece {
        std::uint64_t first;
        std::uint64_t logical;
    };
    struct Stream {
        std::vector<Piece> pieces;
        std::uint64_t bytes = 0;
    };

    void walk(const ReadJob& job);
    std::uint64_t dataOffset(const ReadJob& job, std::uint64_t& end) const;
    bool complete() const;
    std::uint64_t wholeRecords() const;
    std::uint64_t addPacket(std::uint64_t at, std::uint64_t end, const ReadJob& job);
    void addPieces(std::uint64_t at, std::uint64_t length, const ReadJob& job);
    template <class Visit>
    void visit(std::size_t field, std::uint64_t first, std::uint64_t count, const Visit& piece) const;

    const E57Pages& pages_;
    const E57Scan& scan_;
    std::vector<Stream> streams_;
    std::uint64_t records_ = 0;
    std::uint64_t walked_ = 0;
    std::string damage_;
};

}  // namespace vestige
