#include "core/base/AtomicFile.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace vestige {

AtomicFile::AtomicFile(std::filesystem::path place) : place_(std::move(place)) {
    temporary_ = place_.parent_path() / ("." + place_.stem().string() + ".partial-" +
                                         std::to_string(::getpid()) + place_.extension().string());
}

AtomicFile::~AtomicFile() {
    if (committed_) return;
    stream_.close();
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

Status AtomicFile::open() {
    std::error_code problem;
    if (std::filesystem::is_directory(place_))
        return fail(ErrorCode::output, "a folder of this name is in the way of the file", place_.string());
    if (place_.has_parent_path()) std::filesystem::create_directories(place_.parent_path(), problem);
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

Status AtomicFile::commit() {
    if (stream_.is_open()) {
        stream_.flush();
        const bool good = stream_.good();
        stream_.close();
        if (!good || stream_.fail())
            return fail(ErrorCode::output, "writing failed before the end of the file", place_.string(),
                        "is the disk full?");
    }
    std::error_code problem;
    std::filesystem::rename(temporary_, place_, problem);
    if (problem)
        return fail(ErrorCode::output, "the finished file cannot be put in place", place_.string(),
                    problem.message());
    committed_ = true;
    return {};
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
