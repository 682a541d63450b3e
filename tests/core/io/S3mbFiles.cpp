#include "tests/core/io/S3mbFiles.h"

namespace vestige::test {
namespace {

S3mbWriter box() {
    S3mbWriter writer;
    for (int i = 0; i < 12; ++i) writer.put(0.0);
    return writer;
}

S3mbWriter vertices(const S3mbPoints& part) {
    S3mbWriter writer;
    const auto count = static_cast<std::uint32_t>(part.positions.size());
    writer.put(count).put<std::uint16_t>(3).put<std::uint16_t>(12);
    for (const Eigen::Vector3f& point : part.positions) writer.put(point.x()).put(point.y()).put(point.z());
    writer.put<std::uint32_t>(0);  // normals
    writer.put(static_cast<std::uint32_t>(part.colors.size()));
    if (!part.colors.empty()) writer.put<std::uint16_t>(4).put<std::uint16_t>(0);
    for (const std::uint32_t color : part.colors) writer.put(color);
    writer.put<std::uint16_t>(0).put<std::uint16_t>(0);  // texture coordinates
    writer.put<std::uint16_t>(0).put<std::uint16_t>(0);  // instances
    if (part.intensities.empty()) {
        writer.put<std::uint32_t>(0).text("{}").align();
    } else {
        writer.put<std::uint32_t>(1).put(static_cast<std::uint32_t>(part.intensities.size()));
        writer.put<std::uint16_t>(1).put<std::uint16_t>(3);
        for (const std::uint16_t intensity : part.intensities) writer.put(intensity);
        writer.text(R"({"Intensity":0})").align();
    }
    return writer.put<std::uint32_t>(0);  // tangents
}

S3mbWriter skeleton(const S3mbPoints& part) {
    S3mbWriter indices;
    indices.put<std::uint32_t>(0).put<std::uint8_t>(0).put<std::uint8_t>(0).put(part.primitive);
    indices.put<std::uint8_t>(0).put<std::int32_t>(0);
    S3mbWriter writer;
    writer.text(part.name).align().put<std::uint32_t>(0).stream(vertices(part));
    return writer.put<std::int32_t>(1).stream(indices).raw(box().bytes());
}

S3mbWriter lod(const S3mbPoints& part) {
    S3mbWriter writer;
    writer.put(1.0F).put<std::uint16_t>(1);
    for (int i = 0; i < 4; ++i) writer.put(0.0);
    writer.raw(box().bytes()).text(part.child).put<std::int32_t>(1);
    for (int i = 0; i < 12; ++i) writer.put(i % 5 == 0 ? 1.0 : 0.0);
    writer.put(part.place.x()).put(part.place.y()).put(part.place.z()).put(1.0);
    return writer.put<std::int32_t>(1).text(part.name).text("");
}

std::string stored(const std::string& content) {
    std::string bytes;
    for (std::size_t at = 0; at == 0 || at < content.size(); at += 65535) {
        const std::string block = content.substr(at, 65535);
        const auto size = static_cast<std::uint16_t>(block.size());
        S3mbWriter head;
        head.put<std::uint8_t>(at + 65535 >= content.size()).put(size);
        bytes += head.put(static_cast<std::uint16_t>(~size)).bytes() + block;
    }
    return bytes;
}

std::string zlibOf(const std::string& content) {
    std::uint32_t a = 1, b = 0;  // Adler-32, RFC 1950
    for (const char c : content) {
        a = (a + static_cast<std::uint8_t>(c)) % 65521;
        b = (b + a) % 65521;
    }
    std::string sum;
    for (const std::uint32_t part : {b, a}) {
        sum += static_cast<char>(part >> 8);
        sum += static_cast<char>(part);
    }
    return "\x78\x01" + stored(content) + sum;
}

std::string gzipOf(const std::string& content) {
    std::uint32_t crc = 0xffffffff;  // RFC 1952
    for (const char c : content) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
    }
    S3mbWriter tail;
    tail.put(~crc).put(static_cast<std::uint32_t>(content.size()));
    return std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10) + stored(content) + tail.bytes();
}

std::string packageOf(const std::vector<S3mbPoints>& parts, const S3mbWriter& skeletons) {
    S3mbWriter lods, textures, package;
    lods.put(static_cast<std::int32_t>(parts.size()));
    for (const S3mbPoints& part : parts) lods.raw(lod(part).bytes());
    textures.put<std::int32_t>(0);
    package.put<std::uint32_t>(0).stream(lods.align()).stream(skeletons).stream(textures);
    return package.text("{}").text("").bytes();
}

}  // namespace

std::string s3mbPackage(const std::vector<S3mbPoints>& parts) {
    S3mbWriter skeletons;
    skeletons.put(static_cast<std::int32_t>(parts.size()));
    for (const S3mbPoints& part : parts) skeletons.stream(skeleton(part));
    return packageOf(parts, skeletons);
}

std::string s3mbDracoPackage(const std::string& stream, std::int32_t position, std::int32_t normal,
                             std::int32_t color) {
    const S3mbPoints part;
    S3mbWriter packed, one, skeletons;
    packed.put<std::int32_t>(0).put(position).put(normal).put(color).put<std::uint32_t>(0);
    packed.put<std::uint32_t>(0).put<std::uint32_t>(0).align().text(stream).align().text("{}").align();
    one.text(part.name).align().put<std::uint32_t>(1).stream(packed);
    one.put<std::uint16_t>(0).put<std::uint16_t>(0).raw(box().bytes());
    skeletons.put<std::int32_t>(1).stream(one);
    return packageOf({part}, skeletons);
}

std::string s3mbFile(const std::string& package, std::uint32_t packing, float version) {
    const std::string packed = packing == 0 ? package : packing == 1 ? zlibOf(package) : gzipOf(package);
    S3mbWriter writer;
    writer.put(version).put(packing).put(static_cast<std::uint32_t>(package.size()));
    return writer.text(packed).bytes();
}

std::string s3mbIndex(const std::string& lodType, const std::vector<std::string>& urls,
                      const std::string& rest) {
    std::string roots;
    for (const std::string& url : urls) roots += (roots.empty() ? "" : ",") + ("{\"url\":\"" + url + "\"}");
    return R"({"version":"3.01","dataType":"PointCloud","pyramidSplitType":"Octree","lodType":")" + lodType +
           "\",\"rootTiles\":[" + roots + "]" + rest + "}";
}

}  // namespace vestige::test
