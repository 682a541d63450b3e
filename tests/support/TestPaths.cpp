#include "tests/support/TestPaths.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>

namespace vestige::test {

std::filesystem::path dataFile(const std::string& name) {
    return std::filesystem::path(VESTIGE_TEST_DATA) / name;
}

std::optional<std::filesystem::path> sharedFile(const std::string& name) {
    const char* chosen = std::getenv("VESTIGE_SHARED_DATA");
    const std::filesystem::path file = std::filesystem::path(chosen ? chosen : VESTIGE_SHARED_DATA) / name;
    if (!std::filesystem::exists(file)) return std::nullopt;
    return std::filesystem::weakly_canonical(file);
}

TemporaryFolder::TemporaryFolder() {
    static std::atomic<int> counter = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("vestige-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace vestige::test
