#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace vestige::test {

/// A file that the repository holds: tests/data/NAME.
std::filesystem::path dataFile(const std::string& name);

/// A real scan beside the project (shared/data/NAME); nothing where it is absent. Environment:
/// VESTIGE_SHARED_DATA.
std::optional<std::filesystem::path> sharedFile(const std::string& name);

/// A folder of this test alone, emptied when it begins and removed when it ends.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

}  // namespace vestige::test

/// Binds `variable` to a real scan, or reports the test as skipped where the scan is absent.
#define VESTIGE_SHARED_OR_SKIP(variable, name)                                                \
    const auto variable##Found = ::vestige::test::sharedFile(name);                           \
    if (!variable##Found) GTEST_SKIP() << "skipped: " << (name) << " is not on this machine"; \
    const std::filesystem::path& variable = *variable##Found
