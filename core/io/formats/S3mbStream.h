#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/io/Bytes.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// Refuses with the advice that holds for every S3MB file that is not understood.
[[noreturn]] void refuseS3mb(const ReadJob& job, std::string message, const std::string& expected);

/// Walks over a stretch of an unpacked S3MB tile; never past its end. Parts that the format calls streams (a
/// length, then so many bytes) are walked over as streams of their own.
class S3mbStream {
  public:
    S3mbStream(std::span<const std::byte> bytes, std::string name, const ReadJob& job)
        : bytes_(bytes), name_(std::move(name)), job_(job) {}

    template <class Number>
    Number take() {
        return load<Number>(takeBytes(1, sizeof(Number)).data());
    }
    /// `count` times `size` bytes, not copied.
    std::span<const std::byte> takeBytes(std::size_t count, std::size_t size);
    void skip(std::size_t bytes) { takeBytes(bytes, 1); }
    /// A count of things of which each takes `least` bytes at least.
    std::size_t takeCount(std::size_t least);
    std::string takeString();
    S3mbStream takeStream(const std::string& name);
    /// To the next multiple of four bytes from the stream's beginning; past the end is allowed here.
    void align();

    [[noreturn]] void refuse(const std::string& message, const std::string& expected) const;

  private:
    std::span<const std::byte> bytes_;
    std::string name_;
    const ReadJob& job_;
    std::size_t at_ = 0;
};

}  // namespace vestige
