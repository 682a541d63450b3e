#include "core/io/formats/PlyFormat.h"

#include "core/io/Bytes.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/WriteJob.h"
#include "core/io/formats/PlyBody.h"

namespace vestige {
namespace {

std::string_view versionText(PlyEncoding encoding) {
    switch (encoding) {
        case PlyEncoding::ascii:
            return "1.0, ascii";
        case PlyEncoding::littleEndian:
            return "1.0, binary little endian";
        case PlyEncoding::bigEndian:
            break;
    }
    return "1.0, binary big endian";
}

std::string_view typeName(ScalarType type) {
    switch (type) {
        case ScalarType::uint8:
            return "uchar";
        case ScalarType::uint16:
            return "ushort";
        case ScalarType::float32:
            return "float";
        default:
            return "double";
    }
}

std::string header(const TriangleMesh& mesh, const std::vector<PointColumn>& columns) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment Vestige\n";
    text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
    for (const PointColumn& column : columns)
        text += "property " + std::string(typeName(column.type)) + " " + column.name + "\n";
    if (mesh.isMesh())
        text += "element face " + std::to_string(mesh.triangles.size()) +
                "\nproperty list uchar uint vertex_indices\n";
    return text + "end_header\n";
}

void writeFaces(AtomicFile& file, const std::vector<Triangle>& triangles, const JobControl& control) {
    std::vector<std::byte> face(1 + sizeof(Triangle));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        stepWriting(control, i, triangles.size());
        face[0] = std::byte{3};
        for (std::size_t k = 0; k < 3; ++k) store(face.data() + 1 + 4 * k, triangles[i][k]);
        file.write(face);
    }
}

}  // namespace

bool PlyFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    return head.size() > 4 && head[0] == std::byte{'p'} && head[1] == std::byte{'l'} &&
           head[2] == std::byte{'y'} &&
           (head[3] == std::byte{'\n'} || head[3] == std::byte{'\r'} || head[3] == std::byte{' '});
}

Result<LoadedGeometry> PlyFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        const PlyHeader header = parsePlyHeader(content->text(), job);
        TriangleMesh mesh = readPlyBody(content->text(), header, job);
        return loaded(std::move(mesh), "PLY", std::string(versionText(header.encoding)), job);
    });
}

Status PlyFormat::write(const std::filesystem::path& file, const TriangleMesh& geometry,
                        const WriteOptions& options, const JobControl& control) const {
    return writeAtomically(file, [&](AtomicFile& target) {
        const std::vector<PointColumn> columns = pointColumns(geometry.vertices, SourceGrid(options.source));
        target.write(header(geometry, columns));
        writeRecords(target, columns, geometry.vertices.size(), control);
        writeFaces(target, geometry.triangles, control);
    });
}

}  // namespace vestige
