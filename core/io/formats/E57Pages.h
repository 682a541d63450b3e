#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// The pages of an E57 file (ASTM E2807, 7): each ends with the CRC-32C of what comes before it, in big
/// endian. Positions in the file are physical; positions in the content without the checksums are logical.
class E57Pages {
  public:
    /// Checks the header's page, which says how large pages are, where the file ends and where its XML is.
    /// Refuses what is no E57 file; a file that ends before its header says so, unless `salvage`.
    E57Pages(std::span<const std::byte> file, bool salvage, ReadJob& job);

    std::uint64_t logicalSize() const { return pages_ * content_; }
    std::uint64_t physical(std::uint64_t logical) const {
        return logical / content_ * page_ + logical % content_;
    }
    /// Refuses a position outside of the file or inside a checksum, at `byte`, where it was said.
    std::uint64_t logical(std::uint64_t physical, const std::string& what, std::size_t byte,
                          const ReadJob& job) const;

    std::uint64_t xmlOffset() const { return xmlOffset_; }  ///< logical
    std::uint64_t xmlLength() const { return xmlLength_; }

    /// Checks every page, in parallel. Refuses at the first damaged one, or notes them where the file is to
    /// be salvaged.
    void checkAll(const ReadJob& job);
    /// Checks the pages of a part of the content and refuses at the first damaged one.
    void check(std::uint64_t logical, std::uint64_t length, const ReadJob& job) const;
    /// Whether checkAll() found a damaged page in a part of the content.
    bool damaged(std::uint64_t logical, std::uint64_t length) const;
    /// What is damaged of a file that is salvaged, wherever it lies; empty of a whole one. After checkAll().
    std::string damage() const;

    /// Copies content, which must lie inside the file, without checking it.
    void copy(std::uint64_t logical, std::span<std::byte> to) const;

  private:
    bool whole(std::uint64_t page) const;
    [[noreturn]] void refusePage(std::uint64_t page, const ReadJob& job) const;

    std::span<const std::byte> file_;
    bool salvage_ = false;
    std::uint64_t page_ = 1024;
    std::uint64_t content_ = 1020;
    std::uint64_t pages_ = 0;
    std::uint64_t xmlOffset_ = 0;
    std::uint64_t xmlLength_ = 0;
    std::uint64_t missing_ = 0;  ///< bytes that the header promises beyond the end of the file
    std::vector<std::uint64_t> damaged_;
};

}  // namespace vestige
