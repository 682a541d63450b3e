#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <utility>

#include "core/base/Descriptor.h"
#include "core/base/Result.h"

namespace vestige {

/// A file read by place into the caller's memory, by many threads at once. Read in pieces that stay in the
/// processor's cache, a large file costs less than mapped: no page of it enters the process.
class PositionedFile {
  public:
    /// ErrorCode::input when the file cannot be opened.
    static Result<PositionedFile> open(const std::filesystem::path& file);
    /// Fills `bytes` from byte `offset` of the file on; false when the file ends before or a device fails.
    bool readAt(std::size_t offset, std::span<std::byte> bytes) const;

  private:
    explicit PositionedFile(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}
    Descriptor descriptor_;
};

}  // namespace vestige
