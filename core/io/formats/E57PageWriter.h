#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/AtomicFile.h"

namespace vestige {

/// Cuts content into pages of 1024 bytes that end with their checksum (see E57Pages).
class E57PageWriter {
  public:
    static constexpr std::uint64_t kPage = 1024;
    static constexpr std::uint64_t kContent = 1020;

    explicit E57PageWriter(AtomicFile& file) : file_(file) {}
    void add(std::span<const std::byte> content);
    /// Fills the last page up with zeros.
    void finish();

    static std::uint64_t physical(std::uint64_t logical) {
        return logical / kContent * kPage + logical % kContent;
    }
    /// Bytes of a file with so much content.
    static std::uint64_t fileSize(std::uint64_t content) {
        return (content + kContent - 1) / kContent * kPage;
    }

  private:
    void emitPage();

    AtomicFile& file_;
    std::vector<std::byte> page_;
};

}  // namespace vestige
