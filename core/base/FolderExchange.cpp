#include "core/base/FolderExchange.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "core/base/Durable.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

bool rename2(const fs::path& from, const fs::path& to, unsigned flags) {
    return ::syscall(SYS_renameat2, AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0;
}

/// A folder of this user's own that is no link and no mount.
bool isPlain(const fs::path& place) {
    struct stat folder {
    }, parent{};
    return ::lstat(place.c_str(), &folder) == 0 && S_ISDIR(folder.st_mode) &&
           ::stat(place.parent_path().c_str(), &parent) == 0 && folder.st_dev == parent.st_dev &&
           folder.st_uid == ::geteuid();
}

bool holdsOnly(const fs::path& place, const std::vector<std::string>& known) {
    std::set<std::string> files(known.begin(), known.end());
    std::set<std::string> folders;
    for (const auto& name : known)
        for (auto folder = fs::path(name).parent_path(); !folder.empty(); folder = folder.parent_path())
            folders.insert(folder.generic_string());
    std::error_code error;
    for (fs::recursive_directory_iterator entry(place, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        const auto type = entry->symlink_status(unknown).type();
        const std::string name = entry->path().lexically_relative(place).generic_string();
        const bool expected = type == fs::file_type::directory
                                  ? folders.contains(name)
                                  : type == fs::file_type::regular && files.contains(name);
        if (!expected) return false;
    }
    return !error;
}

/// Whoever has a shell open in a folder does not want to find himself in one that is gone.
bool somebodyWorksIn(const fs::path& place) {
    std::error_code error;
    const std::string whole = fs::canonical(place, error).string();
    if (error) return true;
    for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unknown;
        const std::string at = fs::read_symlink(entry->path() / "cwd", unknown).string();
        if (!unknown && (at == whole || at.starts_with(whole + "/"))) return true;
    }
    return false;
}

}  // namespace

bool exchangeFolders(const fs::path& ready, const fs::path& place, const std::vector<std::string>& known) {
    if (!isPlain(place) || !holdsOnly(place, known) || somebodyWorksIn(place)) return false;
    std::error_code error;
    const auto mode = fs::status(place, error).permissions();
    if (!error) fs::permissions(ready, mode, error);
    if (error || !rename2(ready, place, RENAME_EXCHANGE)) return false;
    syncFolder(place.parent_path());
    return true;
}

bool renameFolder(const fs::path& ready, const fs::path& place) {
    if (!rename2(ready, place, RENAME_NOREPLACE)) return false;
    syncFolder(place.parent_path());
    return true;
}

}  // namespace vestige
