#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// A file that appears whole or not at all: it is written beside its place under another name and renamed by
/// commit(). Destroyed without commit() it leaves what stood there before untouched and nothing of its own. A
/// device or a pipe (/dev/null, /dev/stdout) is written to directly. A symbolic link is replaced, and what it
/// leads to, evidence perhaps, stays as it is. What is committed outlasts a power failure (Durable.h); what a
/// killed process left beside the place is cleared away by the next that writes there.
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path place);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Makes the folder that holds the file where it is missing, and opens the stream. ErrorCode::output
    /// otherwise.
    Status open();
    /// For writers that want a path (LASzip, VTK, Qt): the name to write to until commit(). It keeps the
    /// extension.
    const std::filesystem::path& temporaryPath() const { return temporary_; }
    std::ofstream& stream() { return stream_; }
    void write(std::string_view text) {
        stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    void write(std::span<const std::byte> bytes);
    /// Closes and renames; ErrorCode::output when a write or the renaming failed.
    Status commit();
    /// The same for several files, all or none: where one cannot be put in place, the others' places are as
    /// they were before.
    static Status commit(const std::vector<AtomicFile*>& files);

  private:
    Status finish();

    std::filesystem::path place_;
    std::filesystem::path temporary_;
    std::ofstream stream_;
    bool device_ = false;
    bool committed_ = false;
};

/// Whether both name the same place, or are names of the same file. An empty name is none.
bool samePlace(const std::filesystem::path& a, const std::filesystem::path& b);

/// Writes `text` as the whole content of `place`, atomically.
Status writeTextFile(const std::filesystem::path& place, std::string_view text);
/// The whole content of a file; ErrorCode::input when it cannot be read or is larger than `limitBytes`.
Result<std::string> readTextFile(const std::filesystem::path& file,
                                 std::size_t limitBytes = std::size_t{1} << 30);

}  // namespace vestige
