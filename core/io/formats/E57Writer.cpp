#include "core/io/formats/E57Writer.h"

#include <algorithm>
#include <cstring>

#include "core/base/Hash.h"
#include "core/io/Bytes.h"
#include "core/io/ReadJob.h"
#include "core/io/WriteJob.h"
#include "core/io/formats/E57PageWriter.h"
#include "core/io/formats/E57WriteXml.h"

namespace vestige {
namespace {

constexpr std::uint64_t kHeader = 48;

std::vector<std::byte> header(std::uint64_t fileSize, std::uint64_t xmlOffset, std::uint64_t xmlLength) {
    std::vector<std::byte> bytes(kHeader);
    constexpr std::string_view kSignature = "ASTM-E57";
    std::memcpy(bytes.data(), kSignature.data(), kSignature.size());
    store<std::uint32_t>(bytes.data() + 8, 1);
    store<std::uint64_t>(bytes.data() + 16, fileSize);
    store<std::uint64_t>(bytes.data() + 24, xmlOffset);
    store<std::uint64_t>(bytes.data() + 32, xmlLength);
    store<std::uint64_t>(bytes.data() + 40, E57PageWriter::kPage);
    return bytes;
}

void tellLosses(const TriangleMesh& geometry, const FileInfo* source, const JobControl& control) {
    if (geometry.isMesh())
        control.message("E57 holds no surfaces: " + counted(geometry.triangles.size(), "triangle") +
                        " left out, their corners are written as points");
    if (!source) return;
    if (!source->images.empty())
        control.message(counted(source->images.size(), "image") + " of the source not written");
    if (!source->crs.empty() && !isWkt(source->crs))
        control.message("the reference system is not in WKT and is not written: " + source->crs);
}

}  // namespace

Status writeE57(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                const JobControl& control) {
    return writeAtomically(file, [&](AtomicFile& target) {
        tellLosses(geometry, options.source, control);
        const std::vector<E57Part> parts = e57Parts(geometry.vertices, options.source);
        std::vector<E57Section> sections;
        std::uint64_t end = kHeader;
        for (const E57Part& part : parts) end = sections.emplace_back(part, end).end();
        const std::uint64_t xmlLength = e57Xml(parts, sections, options.source, {}).size();
        E57PageWriter pages(target);
        pages.add(header(E57PageWriter::fileSize(end + xmlLength), E57PageWriter::physical(end), xmlLength));
        Sha256 hash;
        std::size_t done = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            sections[i].write(
                [&](std::span<const std::byte> bytes) {
                    hash.add(bytes);
                    pages.add(bytes);
                },
                [&](std::size_t records) {
                    if (control.cancelled()) throw ErrorException{cancelledError()};
                    control.progress(
                        static_cast<double>(done + records) /
                            static_cast<double>(std::max<std::size_t>(geometry.vertices.size(), 1)),
                        "writing");
                });
            done += parts[i].points;
        }
        hash.add(e57Xml(parts, sections, options.source, {}));
        const std::string xml = e57Xml(parts, sections, options.source, hash.hex());
        pages.add(std::as_bytes(std::span(xml)));
        pages.finish();
    });
}

}  // namespace vestige
