#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vestige::test {

/// Makes E57 files byte by byte, with nothing of Vestige's writer: sections, then the XML, then pages with
/// their checksums.
class E57Craft {
  public:
    /// A data packet of the byte streams.
    static std::string packet(const std::vector<std::string>& streams);
    /// Adds a CompressedVector section of these packets and returns its place in the file (fileOffset).
    std::uint64_t section(const std::string& packets);
    /// Adds a Blob section and returns its place.
    std::uint64_t blob(const std::string& bytes);
    /// The whole file with this XML behind the sections.
    std::string file(const std::string& xml) const;

    /// The XML of a file whose data3D holds `scans`, or whose root holds `more`.
    static std::string root(const std::string& scans, const std::string& more = {});
    /// A child of data3D; `more` are its elements beside the points.
    static std::string scan(std::uint64_t section, std::uint64_t records, const std::string& prototype,
                            const std::string& more = {});

    /// `content` cut into pages of 1024 bytes with right checksums.
    static std::string paged(std::string content);

    std::string content = std::string(48, '\0');  ///< logical
};

/// Little endian.
template <class Number>
std::string bytesOf(std::initializer_list<Number> numbers) {
    return {reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(Number)};
}

}  // namespace vestige::test
