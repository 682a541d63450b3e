#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/Result.h"

namespace vestige {

/// A folder of results that appears whole or not at all: everything is written into a folder beside the final
/// one and moved into place by commit(). Destroyed without it, nothing of its own is left and what stood in
/// the final folder is untouched.
class OutputFolder {
  public:
    explicit OutputFolder(const std::filesystem::path& place);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Makes the folder to write into. ErrorCode::output when it cannot be made or `place` is no folder.
    Status open();
    /// The folder to write into until commit().
    const std::filesystem::path& folder() const { return temporary_; }
    /// Where to write the file that will be called `name` ("screenshots/top.png"); its folder is made.
    std::filesystem::path path(const std::string& name);
    /// Names of the files written so far, sorted, with '/'.
    std::vector<std::string> files() const;
    /// Moves every file into place, replacing those of the same name; `obsolete` (names) are removed there.
    /// When a file cannot be moved everything is put back as it was: ErrorCode::output.
    Status commit(const std::vector<std::string>& obsolete = {});

  private:
    std::filesystem::path place_;
    std::filesystem::path temporary_;
};

}  // namespace vestige
