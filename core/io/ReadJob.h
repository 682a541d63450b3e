#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"

namespace vestige {

/// One reading of one file: where it fails, what it warns of, how far it is. The functions that refuse throw
/// ErrorException, which FileFormat's public functions turn into their Result (`guarded`).
class ReadJob {
  public:
    ReadJob(std::filesystem::path path, const JobControl& control)
        : path_(std::move(path)), control_(control) {}

    const std::filesystem::path& path() const { return path_; }
    std::string place() const { return path_.string(); }

    /// What is wrong and what was expected, at the file, one of its lines (from 1) or bytes (from 0).
    [[noreturn]] void refuse(std::string message, const std::string& expected = {}) const;
    [[noreturn]] void refuseLine(std::size_t line, std::string message,
                                 const std::string& expected = {}) const;
    [[noreturn]] void refuseByte(std::size_t byte, std::string message,
                                 const std::string& expected = {}) const;

    /// For the user, kept in FileInfo::warnings.
    void warn(std::string sentence);
    std::vector<std::string>& warnings() { return warnings_; }

    /// Cheap enough for every item: reports and looks for a cancel once in 65536 calls.
    void step(std::size_t done, std::size_t total) const {
        if ((done & 0xffff) == 0) report(done, total);
    }
    void report(std::size_t done, std::size_t total) const;

  private:
    std::filesystem::path path_;
    JobControl control_;
    std::vector<std::string> warnings_;
};

/// "1 point", "5 points".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace vestige
