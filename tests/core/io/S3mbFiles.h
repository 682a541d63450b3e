#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace vestige::test {

/// A part of an S3MB tile, written by SuperMap's specification (Specification/S3MB/S3MBBinary.md).
class S3mbWriter {
  public:
    template <class Number>
    S3mbWriter& put(Number value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    S3mbWriter& raw(const std::string& bytes) {
        bytes_ += bytes;
        return *this;
    }
    S3mbWriter& text(const std::string& text) {
        return put(static_cast<std::uint32_t>(text.size())).raw(text);
    }
    S3mbWriter& align() {
        while (bytes_.size() % 4 != 0) bytes_ += '\0';
        return *this;
    }
    S3mbWriter& stream(const S3mbWriter& part) { return text(part.bytes_); }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

struct S3mbPoints {
    std::string name = "points";
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> colors;       ///< 0xAABBGGRR
    std::vector<std::uint16_t> intensities;  ///< as the attribute "Intensity"
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    std::string child;
    std::uint8_t primitive = 1;
};

/// A level of detail and a skeleton for each.
std::string s3mbPackage(const std::vector<S3mbPoints>& parts);
/// One level and one skeleton whose points are a Draco stream, with the numbers of its attributes.
std::string s3mbDracoPackage(const std::string& stream, std::int32_t position, std::int32_t normal,
                             std::int32_t color);
/// `package` in a file: packed as 0 (not), 1 (zlib) or 2 (gzip), the latter in stored blocks.
std::string s3mbFile(const std::string& package, std::uint32_t packing = 0, float version = 3.01F);
/// The inside of an index; `rest` follows the usual keys.
std::string s3mbIndex(const std::string& lodType, const std::vector<std::string>& urls,
                      const std::string& rest = {});

}  // namespace vestige::test
