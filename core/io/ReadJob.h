#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/FileStamp.h"
#include "core/base/JobControl.h"
#include "core/base/Result.h"

namespace vestige {

/// What of a damaged file is whole: how many points, and in words "the first 12 of 40 points".
struct WholePart {
    std::size_t points = 0;
    std::string words;
};

/// One reading of one file: where it fails, what it warns of, how far it is. The functions that refuse throw
/// ErrorException, which FileFormat's public functions turn into their Result (`guarded`).
class ReadJob {
  public:
    /// `salvage` as in ReadOptions.
    ReadJob(std::filesystem::path path, const JobControl& control, bool salvage = false)
        : path_(std::move(path)), control_(control), salvage_(salvage) {}

    const std::filesystem::path& path() const { return path_; }
    std::string place() const { return path_.string(); }

    /// What is wrong and what was expected, at the file, one of its lines (from 1) or bytes (from 0).
    [[noreturn]] void refuse(std::string message, const std::string& expected = {}) const;
    [[noreturn]] void refuseLine(std::size_t line, std::string message,
                                 const std::string& expected = {}) const;
    [[noreturn]] void refuseByte(std::size_t byte, std::string message,
                                 const std::string& expected = {}) const;

    /// Runs `work`, which collects what the file holds and may refuse on its way. Where it does and part of
    /// the points is whole, a salvaging job keeps the refusal as `damage()` and returns; another one adds to
    /// the refusal what could be salvaged.
    void untilDamage(const std::function<void()>& work, const std::function<WholePart()>& whole);
    bool salvages() const { return salvage_; }
    /// A sentence for FileInfo::damage; empty of a file that is whole.
    const std::string& damage() const { return damage_; }

    /// Another file that will be read for this one, which must not change until that is done:
    /// FileInfo::companions.
    void alsoReads(const std::filesystem::path& file);
    const std::vector<std::filesystem::path>& companions() const { return companions_; }
    const std::vector<FileStamp>& companionStamps() const { return companionStamps_; }

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
    bool salvage_;
    std::string damage_;
    std::vector<std::filesystem::path> companions_;
    std::vector<FileStamp> companionStamps_;
    std::vector<std::string> warnings_;
};

/// Adds to a refusal what could be salvaged: `words` as in WholePart.
void offerSalvage(Error& error, const std::string& words);

/// "the first 12 of 40 points", "all 40 points".
std::string firstOf(std::size_t whole, std::size_t promised, const std::string& noun);

/// "1 point", "5 points".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace vestige
