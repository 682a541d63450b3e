#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/core/io/GltfText.h"

namespace vestige::test {

/// CRC-32 as zip archives have it, bit by bit.
inline std::uint32_t crcOf(const std::string& bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc;
}

struct ZipItem {
    std::string name;
    std::string content;
    std::int64_t promised = -1;  ///< the size that the directory says; -1: the true one
    std::int64_t sameAs = -1;    ///< the directory points at the data of this earlier item
    std::uint16_t method = 0;
    std::uint16_t flags = 0;
};

/// An archive of the items as they are (stored, or already deflated).
inline std::string zipOf(const std::vector<ZipItem>& items) {
    std::string archive, directory;
    std::vector<std::uint32_t> places;
    for (const ZipItem& item : items) {
        const auto size = static_cast<std::uint32_t>(
            item.promised < 0 ? item.content.size() : static_cast<std::size_t>(item.promised));
        const std::string facts =
            bytesOf<std::uint16_t>({20, item.flags, item.method, 0, 0}) +
            bytesOf<std::uint32_t>(
                {crcOf(item.content), static_cast<std::uint32_t>(item.content.size()), size}) +
            bytesOf<std::uint16_t>({static_cast<std::uint16_t>(item.name.size()), 0});
        places.push_back(item.sameAs < 0 ? static_cast<std::uint32_t>(archive.size())
                                         : places[static_cast<std::size_t>(item.sameAs)]);
        if (item.sameAs < 0) archive += "PK\3\4" + facts + item.name + item.content;
        directory += "PK\1\2" + bytesOf<std::uint16_t>({20}) + facts + bytesOf<std::uint16_t>({0, 0, 0}) +
                     bytesOf<std::uint32_t>({0, places.back()}) + item.name;
    }
    const auto count = static_cast<std::uint16_t>(items.size());
    return archive + directory + "PK\5\6" + bytesOf<std::uint16_t>({0, 0, count, count}) +
           bytesOf<std::uint32_t>(
               {static_cast<std::uint32_t>(directory.size()), static_cast<std::uint32_t>(archive.size())}) +
           bytesOf<std::uint16_t>({0});
}

/// The parts of a 3MF archive round this model.
inline std::vector<ZipItem> threeMfParts(const std::string& model) {
    return {{"[Content_Types].xml",
             "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default "
             "Extension=\"rels\" "
             "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default "
             "Extension=\"model\" "
             "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
            {"_rels/.rels",
             "<Relationships "
             "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
             "Target=\"/3D/3dmodel.model\" Id=\"r0\" "
             "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
            {"3D/3dmodel.model", model}};
}

/// A model in this unit, of these resources and this build.
inline std::string threeMfModel(const std::string& unit, const std::string& resources,
                                const std::string& build) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model unit=\"" + unit +
           "\" xml:lang=\"en-US\" "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
           resources + "</resources><build>" + build + "</build></model>";
}

/// Object `id`: a tetrahedron with one corner at x, y, z, given as text.
inline std::string threeMfTetrahedron(int id, const std::string& x, const std::string& y,
                                      const std::string& z) {
    const auto vertex = [](const std::string& a, const std::string& b, const std::string& c) {
        return "<vertex x=\"" + a + "\" y=\"" + b + "\" z=\"" + c + "\"/>";
    };
    return "<object id=\"" + std::to_string(id) + "\" type=\"model\"><mesh><vertices>" + vertex(x, y, z) +
           vertex(x + "5", y, z) + vertex(x, y + "5", z) + vertex(x, y, z + "5") +
           "</vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" "
           "v3=\"3\"/>"
           "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" "
           "v3=\"2\"/></triangles></mesh></object>";
}

}  // namespace vestige::test
