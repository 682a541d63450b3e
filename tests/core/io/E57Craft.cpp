#include "tests/core/io/E57Craft.h"

namespace vestige::test {
namespace {

std::uint32_t bitwiseCrc(const std::string& bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78U : 0U);
    }
    return ~crc;
}

std::uint64_t physical(std::uint64_t logical) {
    return logical / 1020 * 1024 + logical % 1020;
}

void align(std::string& bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
}

}  // namespace

std::string E57Craft::packet(const std::vector<std::string>& streams) {
    std::string table;
    std::string body;
    for (const std::string& stream : streams) {
        table += bytesOf<std::uint16_t>({static_cast<std::uint16_t>(stream.size())});
        body += stream;
    }
    std::string bytes = std::string(6, '\0') + table + body;
    align(bytes);
    bytes.replace(
        0, 6,
        std::string("\1\0", 2) + bytesOf<std::uint16_t>({static_cast<std::uint16_t>(bytes.size() - 1),
                                                         static_cast<std::uint16_t>(streams.size())}));
    return bytes;
}

std::uint64_t E57Craft::section(const std::string& packets) {
    const std::uint64_t at = content.size();
    content += std::string("\1\0\0\0\0\0\0\0", 8) +
               bytesOf<std::uint64_t>({32 + packets.size(), physical(at + 32), 0}) + packets;
    return physical(at);
}

std::uint64_t E57Craft::blob(const std::string& bytes) {
    const std::uint64_t at = content.size();
    content += std::string(8, '\0') + bytesOf<std::uint64_t>({16 + bytes.size()}) + bytes;
    align(content);
    return physical(at);
}

std::string E57Craft::file(const std::string& xml) const {
    std::string whole = content + xml;
    const std::uint64_t size = (whole.size() + 1019) / 1020 * 1024;
    whole.replace(0, 48,
                  "ASTM-E57" + bytesOf<std::uint32_t>({1, 0}) +
                      bytesOf<std::uint64_t>({size, physical(content.size()), xml.size(), 1024}));
    return paged(whole);
}

std::string E57Craft::root(const std::string& scans, const std::string& more) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" "
           "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\">" +
           more + "<data3D type=\"Vector\">" + scans + "</data3D></e57Root>\n";
}

std::string E57Craft::scan(std::uint64_t section, std::uint64_t records, const std::string& prototype,
                           const std::string& more) {
    return "<vectorChild type=\"Structure\">" + more + "<points type=\"CompressedVector\" fileOffset=\"" +
           std::to_string(section) + "\" recordCount=\"" + std::to_string(records) +
           "\"><prototype type=\"Structure\">" + prototype +
           "</prototype><codecs type=\"Vector\"/></points></vectorChild>";
}

std::string E57Craft::paged(std::string content) {
    content.resize((content.size() + 1019) / 1020 * 1020);
    std::string file;
    for (std::size_t at = 0; at < content.size(); at += 1020) {
        const std::string page = content.substr(at, 1020);
        const std::uint32_t crc = bitwiseCrc(page);
        file += page;
        for (int shift = 24; shift >= 0; shift -= 8) file += static_cast<char>(crc >> shift & 0xff);
    }
    return file;
}

}  // namespace vestige::test
