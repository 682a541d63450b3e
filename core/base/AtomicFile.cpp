#include "core/base/AtomicFile.h"

#include <cerrno>
#include <cstring>
#include <set>
#include <system_error>
#include <utility>

#include "core/base/Durable.h"
#include "core/base/FileReplacements.h"
#include "core/base/HiddenName.h"
#include "core/base/Leftovers.h"

namespace vestige {
namespace {

constexpr const char* kPartial = ".partial-";
constexpr const char* kReplaced = ".replaced-";

/// A hidden name of this process's own in the folder of `place`, with its extension.
std::filesystem::path beside(const std::filesystem::path& place, const char* what) {
    const HiddenName name = hiddenNameOf(place);
    return place.parent_path() / (name.stem + what + ownerMark() + name.extension);
}

/// What killed processes left of earlier files of this place.
void clearLeftovers(const std::filesystem::path& place) {
    const auto& [stem, extension] = hiddenNameOf(place);
    std::error_code ignored;
    // Where there are no second names for a file, a killed exchange leaves the old file under its second.
    for (const auto& file : leftovers(place.parent_path(), stem + kReplaced, extension))
        if (std::filesystem::exists(place, ignored))
            std::filesystem::remove(file, ignored);
        else
            std::filesystem::rename(file, place, ignored);
    for (const auto& file : leftovers(place.parent_path(), stem + kPartial, extension))
        std::filesystem::remove(file, ignored);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path place) : place_(std::move(place)) {
    std::error_code unknown;  // then it is a file that open() will complain of
    const auto type = std::filesystem::status(place_, unknown).type();
    // /dev/stdout and /dev/fd/3 are links that may lead to a file; they must not be replaced by one.
    const std::string folder = place_.parent_path().string();
    device_ = type == std::filesystem::file_type::character || type == std::filesystem::file_type::fifo ||
              folder == "/dev" || folder == "/dev/fd" || folder.starts_with("/proc/");
    temporary_ = device_ ? place_ : beside(place_, kPartial);
}

AtomicFile::~AtomicFile() {
    if (committed_ || device_) return;
    stream_.close();
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

Status AtomicFile::open() {
    std::error_code problem;
    if (std::filesystem::is_directory(place_, problem))
        return fail(ErrorCode::output, "a folder of this name is in the way of the file", place_.string());
    if (place_.has_parent_path()) std::filesystem::create_directories(place_.parent_path(), problem);
    if (!device_) {
        clearLeftovers(place_);
        // Somebody else's link under this name would be written through.
        std::error_code none;
        std::filesystem::remove(temporary_, none);
    }
    errno = 0;
    stream_.open(temporary_, std::ios::binary | std::ios::trunc);
    if (!stream_)
        return fail(ErrorCode::output, "the file cannot be written", place_.string(),
                    problem ? problem.message() : std::string(std::strerror(errno)));
    return {};
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    stream_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

Status AtomicFile::finish() {
    bool good = true;
    if (stream_.is_open()) {
        stream_.flush();
        good = stream_.good();
        stream_.close();
    }
    if (!good || stream_.fail())
        return fail(ErrorCode::output, "writing failed before the end of the file", place_.string(),
                    "is the disk full?");
    // Renamed before its content is on the disk, a file would be empty after a power failure.
    if (const auto problem = device_ ? std::error_code() : syncFile(temporary_))
        return fail(ErrorCode::output, "writing failed before the end of the file", place_.string(),
                    problem.message());
    return {};
}

Status AtomicFile::commit() {
    return commit({this});
}

Status AtomicFile::commit(const std::vector<AtomicFile*>& files) {
    for (AtomicFile* file : files)
        if (const Status whole = file->finish(); !whole) return whole;
    FileReplacements replaced;
    for (AtomicFile* file : files) {
        if (file->device_) continue;
        if (const auto problem =
                replaced.replace(file->temporary_, file->place_, beside(file->place_, kReplaced)))
            return fail(ErrorCode::output, "the finished file cannot be put in place", file->place_.string(),
                        problem.message());
    }
    replaced.keep();
    std::set<std::filesystem::path> folders;
    for (AtomicFile* file : files) {
        file->committed_ = true;
        if (!file->device_) folders.insert(file->place_.parent_path());
    }
    for (const auto& folder : folders) syncFolder(folder);
    return {};
}

bool samePlace(const std::filesystem::path& a, const std::filesystem::path& b) {
    if (a.empty() || b.empty()) return false;
    std::error_code unknown;
    if (std::filesystem::equivalent(a, b, unknown)) return true;
    const auto whole = [&](const std::filesystem::path& path) {
        const auto absolute = std::filesystem::absolute(path, unknown);
        auto found = std::filesystem::weakly_canonical(absolute, unknown);
        return unknown ? absolute.lexically_normal() : found;
    };
    return whole(a) == whole(b);
}

Status writeTextFile(const std::filesystem::path& place, std::string_view text) {
    AtomicFile file(place);
    if (auto opened = file.open(); !opened) return opened;
    file.write(text);
    return file.commit();
}

Result<std::string> readTextFile(const std::filesystem::path& file, std::size_t limitBytes) {
    std::error_code problem;
    if (std::filesystem::is_directory(file, problem))
        return fail(ErrorCode::input, "this is a folder, a file was expected", file.string());
    // Opening a pipe that nobody writes to would wait for ever.
    if (std::filesystem::exists(file, problem) && !std::filesystem::is_regular_file(file, problem))
        return fail(ErrorCode::input, "this is a device or pipe, a file was expected", file.string());
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) return fail(ErrorCode::input, "the file cannot be opened for reading", file.string());
    const auto size = static_cast<std::size_t>(stream.tellg());
    if (size > limitBytes)
        return fail(ErrorCode::input, "the file is larger than a file of this kind can be", file.string());
    std::string text(size, '\0');
    stream.seekg(0);
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (!stream) return fail(ErrorCode::input, "reading stopped before the end of the file", file.string());
    return text;
}

}  // namespace vestige
