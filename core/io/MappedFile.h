#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "core/base/Result.h"
#include "core/io/MappingFaults.h"

namespace vestige {

/// A regular file's content, read-only in the address space, so that large files cost no copy. Where somebody
/// cuts the file off meanwhile, what is gone reads as zeros and `intact` is false from then on.
class MappedFile {
  public:
    /// ErrorCode::input when the file is missing, a folder, empty or unreadable.
    static Result<MappedFile> open(const std::filesystem::path& file);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&&) = delete;

    std::span<const std::byte> bytes() const { return {data_, size_}; }
    /// False when bytes were asked for that could not be had: what was made of them means nothing.
    bool intact() const { return !watch_.faulted(); }
    /// How many mappings ended broken on this thread so far. A reader that sees it grow while it reads (by its
    /// own file or a companion; readers may share the bytes among threads, but open and end mappings on the
    /// thread that they were called on) has no result.
    static std::size_t brokenReads();
    std::string_view text() const { return {reinterpret_cast<const char*>(data_), size_}; }

  private:
    MappedFile(const std::byte* data, std::size_t size) : data_(data), size_(size), watch_(data, size) {}
    const std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    MappingWatch watch_;
};

}  // namespace vestige
