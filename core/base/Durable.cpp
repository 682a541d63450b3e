#include "core/base/Durable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace vestige {
namespace {

/// 0 or the error number.
int sync(const std::filesystem::path& place, int flags) {
    const int descriptor = ::open(place.c_str(), O_RDONLY | O_CLOEXEC | flags);
    if (descriptor < 0) return errno;
    int problem = 0;
    while (::fsync(descriptor) != 0) {
        problem = errno;
        if (problem != EINTR) break;
        problem = 0;
    }
    ::close(descriptor);
    return problem;
}

}  // namespace

std::error_code syncFile(const std::filesystem::path& file) {
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(file, unknown);
    if (unknown || bytes > kLargestSyncedFile) return {};
    const int problem = sync(file, 0);
    const bool ofTheDisk = problem == EIO || problem == ENOSPC || problem == EDQUOT;
    return ofTheDisk ? std::error_code(problem, std::generic_category()) : std::error_code();
}

void syncFolder(const std::filesystem::path& folder) {
    sync(folder.empty() ? "." : folder, O_DIRECTORY);
}

}  // namespace vestige
