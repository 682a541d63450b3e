// What PLY, PCD, STL and VTK files tell of themselves before their points are read.
#include <algorithm>
#include <limits>
#include <set>

#include "core/io/AttributeNames.h"
#include "core/io/Bytes.h"
#include "core/io/MappedFile.h"
#include "core/io/PointField.h"
#include "core/io/TextScanner.h"
#include "core/io/formats/PcdFormat.h"
#include "core/io/formats/PcdHeader.h"
#include "core/io/formats/PlyFormat.h"
#include "core/io/formats/PlyHeader.h"
#include "core/io/formats/StlFormat.h"
#include "core/io/formats/VtkFormat.h"

namespace vestige {
namespace {

/// Of a text: a digit and a blank.
constexpr std::size_t kShortestNumber = 2;
/// VTK's title, encoding and data set come before its points; where more does, the count is not told.
constexpr std::size_t kVtkHead = 4096;

template <class Describe>
Result<FileInfo> peeked(const std::filesystem::path& file, std::string_view format, const JobControl& control,
                        Describe&& describe) {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        FileInfo info;
        info.path = file;
        info.format = format;
        describe(*content, job, info);
        for (std::string& warning : job.warnings()) info.warnings.push_back(std::move(warning));
        return info;
    });
}

/// `promised`, or as many as the file has room for, with a warning.
std::uint64_t roomFor(std::uint64_t promised, std::size_t bytes, std::size_t bytesOfOne, ReadJob& job) {
    const std::uint64_t room = bytes / std::max<std::size_t>(bytesOfOne, 1);
    if (promised <= room) return promised;
    job.warn("the header promises " + std::to_string(promised) + " points, but the file has room for " +
             std::to_string(room));
    return room;
}

std::vector<std::string> attributesOf(const std::set<PointField>& fields) {
    const auto has = [&](PointField field) { return fields.contains(field); };
    using enum PointField;
    return attributeNames({.intensity = has(intensity),
                           .color = (has(red) && has(green) && has(blue)) || has(packedColor),
                           .classification = has(classification),
                           .gpsTime = has(gpsTime),
                           .normals = has(normalX) && has(normalY) && has(normalZ),
                           .pointSource = has(pointSource),
                           .returnNumber = has(returnNumber),
                           .returnCount = has(returnCount)});
}

/// Bytes of one at least.
std::size_t smallestOf(const PlyElement& element, PlyEncoding encoding) {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += encoding == PlyEncoding::ascii ? kShortestNumber
                 : property.list                ? sizeOf(property.lengthType)
                                                : sizeOf(property.type);
    return bytes;
}

void describePly(const MappedFile& content, ReadJob& job, FileInfo& info) {
    const PlyHeader header = parsePlyHeader(content.text(), job);
    info.version = header.encoding == PlyEncoding::ascii ? "1.0, ascii" : "1.0, binary";
    // The last number of a text may stand without its blank.
    std::size_t left = content.bytes().size() - header.bodyOffset + 1;
    for (const PlyElement& element : header.elements) {
        const std::size_t smallest = smallestOf(element, header.encoding);
        if (element.name == "vertex") {
            info.points = roomFor(element.count, left, smallest, job);
            std::set<PointField> fields;
            for (const PlyProperty& property : element.properties)
                if (!property.list) fields.insert(fieldOfName(property.name));
            info.attributes = attributesOf(fields);
        } else if (element.name == "face") {
            info.triangles =
                std::min<std::uint64_t>(element.count, left / std::max<std::size_t>(smallest, 1));
        }
        const std::size_t most = smallest > 0 ? left / smallest : 0;
        left -= std::min<std::uint64_t>(element.count, most) * smallest;
    }
}

void describePcd(const MappedFile& content, ReadJob& job, FileInfo& info) {
    const PcdHeader header = parsePcdHeader(content.text(), job);
    const bool ascii = header.encoding == PcdEncoding::ascii;
    const bool compressed = header.encoding == PcdEncoding::compressed;
    info.version = (header.version.empty() ? "" : header.version + ", ") + (ascii        ? "ascii"
                                                                            : compressed ? "binary_compressed"
                                                                                         : "binary");
    const std::size_t left = content.bytes().size() - header.bodyOffset + (ascii ? 1 : 0);
    if (compressed) {
        // LZF makes 264 bytes of 3 at best.
        const std::size_t least = std::max<std::size_t>(1, header.stride / 88);
        info.points = roomFor(header.points, left, least, job);
    } else {
        info.points =
            roomFor(header.points, left, ascii ? kShortestNumber * header.columns : header.stride, job);
    }
    std::set<PointField> fields;
    for (const PcdField& field : header.fields) fields.insert(fieldOfName(field.name));
    info.attributes = attributesOf(fields);
}

void describeStl(const MappedFile& content, ReadJob&, FileInfo& info) {
    constexpr std::size_t kHeader = 84, kFacet = 50;
    const auto bytes = content.bytes();
    const bool solid = content.text().starts_with("solid");
    if (bytes.size() < kHeader) return;
    const std::size_t facets = load<std::uint32_t>(bytes.data() + 80);
    if (solid && bytes.size() != kHeader + kFacet * facets) {
        info.version = "ascii";
        return;
    }
    info.version = "binary";
    info.triangles = std::min(facets, (bytes.size() - kHeader) / kFacet);
    info.points = 3 * info.triangles;  // before equal corners become one
}

void describeVtk(const MappedFile& content, ReadJob& job, FileInfo& info) {
    TextScanner scanner(content.text().substr(0, kVtkHead));
    const std::string_view first = scanner.nextLine();
    scanner.nextLine();  // title
    const bool ascii = equalsIgnoringCase(trimmed(scanner.nextLine()), "ascii");
    const std::string_view number = trimmed(first.substr(std::min<std::size_t>(first.size(), 23)));
    const bool plain =
        number.size() <= 8 && number.find_first_not_of("0123456789.") == std::string_view::npos;
    info.version = (plain ? std::string(number) + ", " : "") + (ascii ? "ascii" : "binary");
    while (!scanner.atEnd()) {
        std::string_view line = scanner.nextLine();
        if (!equalsIgnoringCase(takeToken(line), "points")) continue;
        const std::string_view count = takeToken(line);
        const char* at = count.data();
        const auto points = takeNumber(at, count.data() + count.size());
        if (points && *points >= 0 && *points < 1e15)
            info.points =
                roomFor(static_cast<std::uint64_t>(*points), content.bytes().size() - scanner.offset() + 1,
                        3 * (ascii ? kShortestNumber : 1), job);
        return;
    }
}

}  // namespace

Result<FileInfo> PlyFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return peeked(file, "PLY", control, describePly);
}

Result<FileInfo> PcdFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return peeked(file, "PCD", control, describePcd);
}

Result<FileInfo> StlFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return peeked(file, "STL", control, describeStl);
}

Result<FileInfo> VtkFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return peeked(file, "VTK", control, describeVtk);
}

}  // namespace vestige
