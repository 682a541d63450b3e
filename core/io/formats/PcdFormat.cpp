#include "core/io/formats/PcdFormat.h"

#include <algorithm>

#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/WriteJob.h"
#include "core/io/formats/PcdBody.h"

namespace vestige {
namespace {

std::string_view encodingText(PcdEncoding encoding) {
    switch (encoding) {
        case PcdEncoding::ascii:
            return "ascii";
        case PcdEncoding::binary:
            return "binary";
        case PcdEncoding::compressed:
            break;
    }
    return "binary_compressed";
}

/// The usual columns under PCL's names, byte colours packed into one.
std::vector<PointColumn> pcdColumns(const PointCloud& cloud, const SourceGrid& grid) {
    std::vector<PointColumn> columns = pointColumns(cloud, grid);
    for (PointColumn& column : columns)
        if (column.name.size() == 2 && column.name[0] == 'n') column.name = "normal_" + column.name.substr(1);
    if (cloud.attributes().color.empty() || !colorsAreBytes(cloud)) return columns;
    const auto red =
        std::find_if(columns.begin(), columns.end(), [](const auto& c) { return c.name == "red"; });
    *red = {"rgb", ScalarType::uint32, [&colors = cloud.attributes().color](std::size_t i) {
                return 65536.0 * (colors[i][0] / 257) + 256.0 * (colors[i][1] / 257) + colors[i][2] / 257;
            }};
    columns.erase(red + 1, red + 3);
    return columns;
}

char kindOf(ScalarType type) {
    return isInteger(type) ? 'U' : 'F';
}

std::string header(const std::vector<PointColumn>& columns, std::size_t points) {
    std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
    for (const PointColumn& column : columns) {
        fields += " " + column.name;
        sizes += " " + std::to_string(sizeOf(column.type));
        types += std::string(" ") + kindOf(column.type);
        counts += " 1";
    }
    const std::string number = std::to_string(points);
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "\n" + sizes + "\n" +
           types + "\n" + counts + "\nWIDTH " + number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
           number + "\nDATA binary\n";
}

}  // namespace

bool PcdFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return text.starts_with("# .PCD") || text.starts_with("VERSION ") ||
           (text.starts_with("FIELDS ") && text.find("\nSIZE ") != std::string_view::npos);
}

Result<LoadedGeometry> PcdFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        const PcdHeader header = parsePcdHeader(content->text(), job);
        PointCloud cloud = readPcdBody(content->text(), header, job);
        return loaded({std::move(cloud), {}}, "PCD",
                      (header.version.empty() ? "" : header.version + ", ") +
                          std::string(encodingText(header.encoding)),
                      job);
    });
}

Status PcdFormat::write(const std::filesystem::path& file, const TriangleMesh& geometry,
                        const WriteOptions& options, const JobControl& control) const {
    return writeAtomically(file, [&](AtomicFile& target) {
        const std::vector<PointColumn> columns = pcdColumns(geometry.vertices, SourceGrid(options.source));
        target.write(header(columns, geometry.vertices.size()));
        writeRecords(target, columns, geometry.vertices.size(), control);
    });
}

}  // namespace vestige
