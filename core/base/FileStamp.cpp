#include "core/base/FileStamp.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>

namespace vestige {

Result<FileStamp> stampOf(const std::filesystem::path& file) {
    struct stat facts {};
    if (::stat(file.c_str(), &facts) != 0)
        return fail(ErrorCode::input, "the file cannot be opened for reading", file.string(),
                    std::strerror(errno));
    constexpr std::int64_t kNanoseconds = 1000000000;
    return FileStamp{static_cast<std::uint64_t>(facts.st_size),
                     static_cast<std::int64_t>(facts.st_mtim.tv_sec) * kNanoseconds + facts.st_mtim.tv_nsec,
                     facts.st_dev, facts.st_ino};
}

Error changedWhileRead(const std::filesystem::path& file, const FileStamp& before) {
    const auto now = stampOf(file);
    std::string message = "the file changed while it was being read";
    if (!now)
        message += ": it is gone";
    else if (now->bytes != before.bytes)
        message +=
            ": it had " + std::to_string(before.bytes) + " bytes and has " + std::to_string(now->bytes);
    return {ErrorCode::input, message, file.string(),
            "what was read is not used; read it again when nothing writes to it any more"};
}

}  // namespace vestige
