#include "core/io/MappedFile.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/Descriptor.h"

namespace vestige {
namespace {

thread_local std::size_t broken = 0;

}  // namespace

std::size_t MappedFile::brokenReads() {
    return broken;
}

Result<MappedFile> MappedFile::open(const std::filesystem::path& file) {
    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat facts {};
    if (descriptor.number() < 0 || ::fstat(descriptor.number(), &facts) != 0)
        return fail(ErrorCode::input, "the file cannot be opened for reading", file.string(),
                    std::strerror(errno));
    if (S_ISDIR(facts.st_mode))
        return fail(ErrorCode::input, "this is a folder, a file was expected", file.string());
    if (!S_ISREG(facts.st_mode))
        return fail(ErrorCode::input, "this is a device or pipe, a file was expected", file.string());
    if (facts.st_size == 0)
        return fail(ErrorCode::input, "the file is empty", file.string() + ", byte 0",
                    "expected: a point cloud or a mesh");
    const auto size = static_cast<std::size_t>(facts.st_size);
    void* data = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor.number(), 0);
    if (data == MAP_FAILED)
        return fail(ErrorCode::input, "the file cannot be read", file.string(), std::strerror(errno));
    ::madvise(data, size, MADV_SEQUENTIAL);
    return MappedFile(static_cast<const std::byte*>(data), size);
}

MappedFile::~MappedFile() {
    if (!intact()) ++broken;
    // The watch ends first: the addresses may be somebody else's as soon as they are given back.
    { const MappingWatch ended = std::move(watch_); }
    if (data_) ::munmap(const_cast<std::byte*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      watch_(std::move(other.watch_)) {}

}  // namespace vestige
