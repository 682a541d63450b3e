#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace vestige {

/// Files put in place one after the other that stand all or none: destroyed without keep(), everything is as
/// it was before. A place that had a file has one at every moment, the old or the new.
class FileReplacements {
  public:
    FileReplacements() = default;
    ~FileReplacements();
    FileReplacements(const FileReplacements&) = delete;
    FileReplacements& operator=(const FileReplacements&) = delete;

    /// Renames `from` to `to`; a file that stands there goes to `backup`, which must be on the same file
    /// system. The folders of both are made. A folder at `to` is an error.
    std::error_code replace(const std::filesystem::path& from, const std::filesystem::path& to,
                            const std::filesystem::path& backup);
    /// Moves the file at `place` to `backup`; nothing where there is none.
    std::error_code remove(const std::filesystem::path& place, const std::filesystem::path& backup);
    /// What was done stays; the backups are deleted.
    void keep();

  private:
    struct Done {
        std::filesystem::path from;  ///< empty: the place was only cleared
        std::filesystem::path to;
        std::filesystem::path backup;  ///< empty: nothing stood there
    };
    std::vector<Done> done_;
};

}  // namespace vestige
