#include "core/io/formats/DracoCheck.h"

#include <cstdint>
#include <cstring>
#include <string>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr std::size_t kMostAttributes = 64;
constexpr std::size_t kMostComponents = 4;
constexpr std::size_t kBestRatio = 512;
constexpr std::size_t kFreeBytes = std::size_t{1} << 20;
/// Bytes of Draco's number types, by their codes: int8 to uint64, float32, float64, bool.
constexpr std::size_t kTypeBytes[]{0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 1};
constexpr std::uint8_t kKdTree = 1;

class Walker {
  public:
    Walker(std::span<const std::byte> stream, std::size_t offset, const ReadJob& job)
        : stream_(stream), offset_(offset), job_(job) {}

    DracoPromise walk() {
        checkHeader();
        DracoPromise promise;
        promise.points = take<std::uint32_t>();
        const std::size_t decoders = take<std::uint8_t>();
        for (std::size_t i = 0; i < decoders; ++i) promise.bytesPerPoint += attributesOfDecoder();
        if (promise.points > 0x7fffffff ||
            promise.points * promise.bytesPerPoint > kBestRatio * stream_.size() + kFreeBytes)
            refuse("the Draco stream of " + counted(stream_.size(), "byte") + " promises " +
                       counted(promise.points, "point") + " of " + counted(promise.bytesPerPoint, "byte"),
                   "at most " + std::to_string(kBestRatio) + " times its size");
        return promise;
    }

  private:
    [[noreturn]] void refuse(const std::string& message, const std::string& expected) const {
        job_.refuseByte(offset_ + at_, message, expected);
    }

    template <class Number>
    Number take() {
        if (stream_.size() - at_ < sizeof(Number)) refuse("the Draco stream ends early", "a whole stream");
        at_ += sizeof(Number);
        return load<Number>(stream_.data() + at_ - sizeof(Number));
    }

    std::uint32_t takeVarint() {
        std::uint32_t value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            const auto byte = take<std::uint8_t>();
            value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
            if (byte < 0x80) return value;
        }
        refuse("the Draco stream holds a number of more than 32 bits", "a whole stream");
    }

    void checkHeader() {
        if (stream_.size() < 11 || std::memcmp(stream_.data(), "DRACO", 5) != 0)
            refuse("this is no Draco stream", "\"DRACO\"");
        at_ = 5;
        const auto major = take<std::uint8_t>();
        const auto minor = take<std::uint8_t>();
        if (major != 2 || minor > 3)
            refuse("the Draco stream has version " + std::to_string(major) + "." + std::to_string(minor),
                   "2.0 to 2.3");
        if (take<std::uint8_t>() != 0) refuse("the Draco stream is a mesh", "a point cloud");
        method_ = take<std::uint8_t>();
        if (method_ > kKdTree) refuse("the Draco stream has the method " + std::to_string(method_), "0 or 1");
        if ((take<std::uint16_t>() & 0x8000) != 0)
            refuse("the Draco stream holds metadata", "points alone, as 3D Tiles have them");
    }

    std::size_t attributesOfDecoder() {
        const std::size_t count = takeVarint();
        attributes_ += count;
        if (count == 0 || attributes_ > kMostAttributes)
            refuse("the Draco stream has " + counted(attributes_, "attribute"),
                   "1 to " + std::to_string(kMostAttributes));
        std::size_t bytes = 0;
        for (std::size_t i = 0; i < count; ++i) {
            take<std::uint8_t>();
            const std::size_t type = take<std::uint8_t>();
            const std::size_t components = take<std::uint8_t>();
            take<std::uint8_t>();
            takeVarint();
            if (type == 0 || type >= std::size(kTypeBytes) || components == 0 || components > kMostComponents)
                refuse("the Draco stream has an attribute of type " + std::to_string(type) + " with " +
                           counted(components, "component"),
                       "a number type and 1 to 4 components");
            bytes += kTypeBytes[type] * components;
        }
        // Sequential decoders have a byte for each attribute here, a kd-tree has none.
        for (std::size_t i = 0; method_ != kKdTree && i < count; ++i) take<std::uint8_t>();
        return bytes;
    }

    std::span<const std::byte> stream_;
    std::size_t offset_;
    const ReadJob& job_;
    std::size_t at_ = 0;
    std::uint8_t method_ = 0;
    std::size_t attributes_ = 0;
};

}  // namespace

DracoPromise checkDracoStream(std::span<const std::byte> stream, std::size_t offset, const ReadJob& job) {
    return Walker(stream, offset, job).walk();
}

}  // namespace vestige
