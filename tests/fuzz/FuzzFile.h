#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/base/Error.h"

namespace vestige::fuzz {

/// A file in memory (tmpfs) in a folder of this process's own, for readers that take a path; every put()
/// replaces its content.
class FuzzFile {
  public:
    FuzzFile(const std::string& name, const std::string& extension);
    ~FuzzFile();
    FuzzFile(const FuzzFile&) = delete;
    FuzzFile& operator=(const FuzzFile&) = delete;

    void put(std::span<const std::uint8_t> bytes) const;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
    int descriptor_ = -1;
};

/// Ends the run as a finding of libFuzzer's.
[[noreturn]] void finding(const std::string& what);

/// A refusal must be of the input, name the file, say something, and hold nothing that a terminal or JSON
/// would choke on.
void checkError(const Error& error, const std::filesystem::path& file);
/// A sentence for people: short, UTF-8, without control characters.
void checkSentence(const std::string& sentence);

}  // namespace vestige::fuzz
