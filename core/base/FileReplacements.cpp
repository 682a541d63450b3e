#include "core/base/FileReplacements.h"

#include <utility>

namespace vestige {
namespace {

namespace fs = std::filesystem;

std::error_code makeFolderOf(const fs::path& file) {
    std::error_code error;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    return error;
}

/// What stands at `place`: nothing, a file or an error (a folder is one).
struct Standing {
    bool file = false;
    std::error_code error;
};

Standing standingAt(const fs::path& place) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(place, error);
    if (status.type() == fs::file_type::not_found) return {};
    if (error) return {false, error};
    if (fs::is_directory(status)) return {false, std::make_error_code(std::errc::is_a_directory)};
    return {true, {}};
}

}  // namespace

FileReplacements::~FileReplacements() {
    std::error_code ignored;
    for (auto one = done_.rbegin(); one != done_.rend(); ++one) {
        if (!one->from.empty()) fs::rename(one->to, one->from, ignored);
        if (one->backup.empty()) continue;
        std::error_code error;
        fs::rename(one->backup, one->to, error);
        // Renaming to another name of the same file does nothing and leaves both.
        if (!error) fs::remove(one->backup, ignored);
    }
}

std::error_code FileReplacements::replace(const fs::path& from, const fs::path& to, const fs::path& backup) {
    if (const auto error = makeFolderOf(to)) return error;
    const Standing old = standingAt(to);
    if (old.error) return old.error;
    std::error_code error;
    Done done{from, to, {}};
    if (old.file) {
        if (const auto folder = makeFolderOf(backup)) return folder;
        // A second name for the old file, so that the place is never empty; not every file system has those.
        fs::create_hard_link(to, backup, error);
        if (error) {
            fs::rename(to, backup, error);
            if (error) return error;
        }
        done.backup = backup;
    }
    fs::rename(from, to, error);
    if (error) done.from.clear();
    if (!error || !done.backup.empty()) done_.push_back(std::move(done));
    return error;
}

std::error_code FileReplacements::remove(const fs::path& place, const fs::path& backup) {
    const Standing old = standingAt(place);
    if (old.error || !old.file) return old.error;
    if (const auto folder = makeFolderOf(backup)) return folder;
    std::error_code error;
    fs::rename(place, backup, error);
    if (!error) done_.push_back({{}, place, backup});
    return error;
}

void FileReplacements::keep() {
    std::error_code ignored;
    for (const Done& one : done_)
        if (!one.backup.empty()) fs::remove(one.backup, ignored);
    done_.clear();
}

}  // namespace vestige
