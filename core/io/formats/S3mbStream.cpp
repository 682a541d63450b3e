#include "core/io/formats/S3mbStream.h"

#include <algorithm>

namespace vestige {

void refuseS3mb(const ReadJob& job, std::string message, const std::string& expected) {
    job.refuse(std::move(message), expected + "; otherwise export the cloud as LAS or 3D Tiles (PNTS)");
}

void S3mbStream::refuse(const std::string& message, const std::string& expected) const {
    refuseS3mb(job_, message + " (byte " + std::to_string(at_) + " of " + name_ + ", unpacked)", expected);
}

std::span<const std::byte> S3mbStream::takeBytes(std::size_t count, std::size_t size) {
    if (size != 0 && count > (bytes_.size() - at_) / size)
        refuse("the S3MB tile ends before " + std::to_string(count) + " times " + counted(size, "byte"),
               "a whole tile");
    at_ += count * size;
    return bytes_.subspan(at_ - count * size, count * size);
}

std::size_t S3mbStream::takeCount(std::size_t least) {
    const std::size_t count = take<std::uint32_t>();
    if (count > (bytes_.size() - at_) / least)
        refuse("the S3MB tile promises " + std::to_string(count) + " things of at least " +
                   counted(least, "byte"),
               "what its length allows");
    return count;
}

std::string S3mbStream::takeString() {
    const auto text = takeBytes(take<std::uint32_t>(), 1);
    return {reinterpret_cast<const char*>(text.data()), text.size()};
}

S3mbStream S3mbStream::takeStream(const std::string& name) {
    return {takeBytes(take<std::uint32_t>(), 1), name, job_};
}

void S3mbStream::align() {
    at_ = std::min(bytes_.size(), (at_ + 3) / 4 * 4);
}

}  // namespace vestige
