#include "core/io/formats/E57Document.h"

#include <algorithm>
#include <limits>
#include <pugixml.hpp>
#include <set>

#include "core/io/Bytes.h"
#include "core/io/formats/E57ScanXml.h"

namespace vestige {
namespace {

/// pugixml takes some 16 bytes of memory for a byte of the worst XML.
constexpr std::uint64_t kMostXml = std::uint64_t{256} << 20;
constexpr std::uint64_t kBlobHeader = 16;
/// Records whose values are all constant take no room, so that no file size bounds how many they are.
constexpr std::uint64_t kMostRecordsWithoutRoom = 65536;

struct Projection {
    const char* element;
    const char* name;
};
constexpr std::array kProjections{Projection{"pinholeRepresentation", "pinhole"},
                                  Projection{"sphericalRepresentation", "spherical"},
                                  Projection{"cylindricalRepresentation", "cylindrical"},
                                  Projection{"visualReferenceRepresentation", "visual reference"}};

std::uint32_t pixels(const E57Xml& xml, const pugi::xml_node& representation, const char* name) {
    const double value = xml.realOf(representation, name).value_or(0);
    if (!(value >= 0 && value <= std::numeric_limits<std::int32_t>::max()))
        xml.refuse(representation.child(name), "an image cannot be of " + std::string(name) + " pixels",
                   "a number of pixels");
    return static_cast<std::uint32_t>(value);
}

/// The section of a Blob: its number 0, seven bytes that mean nothing, its length, then the bytes.
std::uint64_t checkedBlob(const pugi::xml_node& blob, const E57Xml& xml) {
    const std::uint64_t section = xml.sectionOf(blob);
    const auto length = xml.integerAttribute(blob, "length");
    const std::uint64_t left = xml.pages().logicalSize() - section;
    if (!length || *length < 0 || left < kBlobHeader ||
        static_cast<std::uint64_t>(*length) > left - kBlobHeader)
        xml.refuse(blob, "an image reaches beyond the file", "a length within it");
    const auto bytes = static_cast<std::uint64_t>(*length);
    if (xml.pages().damaged(section, kBlobHeader + bytes)) {
        xml.job().warn("the bytes of an image are damaged");
        return bytes;
    }
    xml.pages().check(section, kBlobHeader, xml.job());
    std::array<std::byte, kBlobHeader> header{};
    xml.pages().copy(section, header);
    if (header[0] != std::byte{0} || load<std::uint64_t>(header.data() + 8) < kBlobHeader + bytes)
        xml.job().refuseByte(xml.pages().physical(section),
                             "the section of an image is of another kind or length than its XML says",
                             "a Blob section");
    return bytes;
}

void addImages(const pugi::xml_node& node, const E57Xml& xml, std::vector<ImageInfo>& images) {
    for (const Projection& projection : kProjections) {
        const pugi::xml_node representation = node.child(projection.element);
        if (!representation) continue;
        ImageInfo& image = images.emplace_back();
        image.name = E57Xml::textOf(node, "name");
        image.projection = projection.name;
        image.fileFromImage = xml.poseOf(node);
        image.width = pixels(xml, representation, "imageWidth");
        image.height = pixels(xml, representation, "imageHeight");
        for (const char* format : {"jpeg", "png"}) {
            const pugi::xml_node blob = representation.child((std::string(format) + "Image").c_str());
            if (!blob) continue;
            image.format = format;
            image.bytes = checkedBlob(blob, xml);
        }
        if (const pugi::xml_node mask = representation.child("imageMask")) checkedBlob(mask, xml);
        if (image.format.empty())
            xml.job().warn("the image '" + image.name + "' has neither a JPEG nor a PNG picture");
    }
}

/// No scan shares its section, and together they have no more points than the file has room for.
class Room {
  public:
    explicit Room(const E57Pages& pages) : bits_(8 * pages.logicalSize()) {}

    void take(const E57Scan& scan, const ReadJob& job) {
        std::uint64_t each = 0;
        for (const E57Field& field : scan.fields) each += field.bits;
        const bool fits = each == 0 ? scan.records <= withoutRoom_ : scan.records <= bits_ / each;
        if (!fits)
            job.refuseByte(scan.byte,
                           "a scan is said to have " + std::to_string(scan.records) +
                               " points, for which the file has no room",
                           "no more than its bytes can hold");
        (each == 0 ? withoutRoom_ : bits_) -= scan.records * std::max<std::uint64_t>(each, 1);
        if (scan.records > 0 && !sections_.insert(scan.section).second)
            job.refuseByte(scan.byte, "two scans are said to lie in the same section",
                           "a section for every scan");
    }

  private:
    std::uint64_t bits_;
    std::set<std::uint64_t> sections_;
    std::uint64_t withoutRoom_ = kMostRecordsWithoutRoom;
};

}  // namespace

E57Document readE57Document(const E57Pages& pages, ReadJob& job) {
    if (pages.xmlLength() > kMostXml)
        job.refuseByte(32, "the XML section is too large: " + counted(pages.xmlLength(), "byte"),
                       "at most " + std::to_string(kMostXml));
    pages.check(pages.xmlOffset(), pages.xmlLength(), job);
    std::string text(pages.xmlLength(), '\0');
    pages.copy(pages.xmlOffset(), std::as_writable_bytes(std::span(text)));
    pugi::xml_document tree;
    // Without its DOCTYPE, and with the five predefined entities only: nothing is fetched, nothing expands.
    const pugi::xml_parse_result parsed =
        tree.load_buffer_inplace(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed)
        job.refuseByte(pages.physical(pages.xmlOffset() +
                                      static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(0, parsed.offset))),
                       "the XML section cannot be parsed: " + std::string(parsed.description()),
                       "well-formed XML");
    const E57Xml xml(pages, job);
    const pugi::xml_node root = tree.child("e57Root");
    if (!root)
        job.refuseByte(pages.physical(pages.xmlOffset()), "the XML section has no root",
                       "an element 'e57Root'");
    E57Document document;
    document.coordinateMetadata = E57Xml::textOf(root, "coordinateMetadata");
    document.library = E57Xml::textOf(root, "e57LibraryVersion");
    document.creation = xml.realOf(root.child("creationDateTime"), "dateTimeValue");
    Room room(pages);
    for (const pugi::xml_node scan : root.child("data3D").children("vectorChild")) {
        document.scans.push_back(parseE57Scan(scan, document.scans.size() + 1, xml));
        room.take(document.scans.back(), job);
    }
    for (const pugi::xml_node image : root.child("images2D").children("vectorChild"))
        addImages(image, xml, document.images);
    return document;
}

std::size_t E57Scan::find(E57Role role) const {
    return static_cast<std::size_t>(std::find_if(fields.begin(), fields.end(),
                                                 [&](const E57Field& field) { return field.role == role; }) -
                                    fields.begin());
}

bool E57Scan::hasAll(std::initializer_list<E57Role> roles) const {
    return std::all_of(roles.begin(), roles.end(), [&](E57Role role) { return has(role); });
}

}  // namespace vestige
