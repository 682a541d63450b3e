#include "core/io/formats/TextFormat.h"

#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/io/Coordinates.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/PointSink.h"
#include "core/io/TextScanner.h"
#include "core/io/WriteJob.h"
#include "core/io/formats/TextLayout.h"

namespace vestige {
namespace {

void readRows(std::string_view text, const TextLayout& layout, ReadJob& job, PointSink& sink) {
    TextScanner scanner(text, layout.bodyOffset, layout.bodyLine);
    std::vector<double> row(layout.fields.size());
    std::size_t longRows = 0;
    while (!scanner.atEnd()) {
        const std::size_t line = scanner.line();
        if ((line & 0xffff) == 0) job.report(scanner.offset(), text.size());
        const std::string_view current = scanner.nextLine();
        if (trimmed(current).empty() || isComment(current)) continue;
        std::size_t bad = 0;
        const std::size_t cells = splitNumbers(current, layout.separator, row, bad);
        if (bad > 0 && bad <= row.size())
            job.refuseLine(line, "value " + std::to_string(bad) + " is missing or no number",
                           counted(row.size(), "number") + " (" + layout.description + ")");
        if (cells < row.size())
            job.refuseLine(line, "the row has " + counted(cells, "value"),
                           counted(row.size(), "number") + " (" + layout.description + ")");
        if (cells > row.size()) ++longRows;
        if (!sink.add(row.data()))
            job.refuseLine(line, std::string(kUnusableCoordinate), std::string(kUsableCoordinates));
    }
    if (longRows > 0)
        job.warn(counted(longRows, "row") + " with more values than columns, the rest not kept");
    if (layout.promised && *layout.promised > sink.size())
        job.refuseLine(scanner.line(), "the file ends after " + counted(sink.size(), "point"),
                       std::to_string(*layout.promised) + " points as its first line says");
    if (layout.promised && *layout.promised < sink.size())
        job.warn("more points than the " + std::to_string(*layout.promised) +
                 " that the first line promises");
}

PointCloud readCloud(std::string_view text, const TextLayout& layout, ReadJob& job) {
    PointSink sink(layout.fields, ColorDepth::guess);
    job.untilDamage([&] { readRows(text, layout, job, sink); },
                    [&] {
                        const std::string words = layout.promised
                                                      ? firstOf(sink.size(), *layout.promised, "point")
                                                      : "the first " + counted(sink.size(), "point");
                        return WholePart{sink.size(), words};
                    });
    return std::move(sink).build();
}

/// Fine enough for a tenth of the 0.1 mm that may be lost, and for small objects in large units; coarse
/// enough that the rounding of float offsets does not show.
int coordinateDecimals(const PointCloud& cloud, const FileInfo* source) {
    if (source && source->scale) {
        const double finest = std::max(source->scale->minCoeff(), 1e-12);
        return std::clamp(static_cast<int>(std::ceil(-std::log10(finest) - 1e-9)), 5, 12);
    }
    const double extent = cloud.bounds().extent().maxCoeff();
    return extent > 0 ? std::clamp(6 - static_cast<int>(std::floor(std::log10(extent))), 5, 12) : 5;
}

std::string cellText(const PointColumn& column, std::size_t point, int decimals) {
    const double value = column.value(point);
    if (column.name.size() == 1) return fixedText(value, decimals);
    return column.type == ScalarType::float32 ? exactText(static_cast<float>(value)) : exactText(value);
}

std::string_view separatorFor(const std::filesystem::path& file) {
    return file.extension() == ".csv" || file.extension() == ".CSV" ? "," : " ";
}

/// PTS knows position, intensity and colour, in this order, and no header but the number of points.
void keepPtsColumns(std::vector<PointColumn>& columns) {
    constexpr std::array<std::string_view, 7> kKnown{"x", "y", "z", "intensity", "red", "green", "blue"};
    std::erase_if(columns, [&](const PointColumn& column) {
        return std::find(kKnown.begin(), kKnown.end(), column.name) == kKnown.end();
    });
}

}  // namespace

bool TextFormat::recognises(std::span<const std::byte>, std::string_view) const {
    return false;  // any text could be points; the extension says so
}

Result<LoadedGeometry> TextFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                        const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        std::string_view text = content->text();
        if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
        const TextLayout layout = recogniseLayout(text, job);
        PointCloud cloud = readCloud(text, layout, job);
        return loaded({std::move(cloud), {}}, "text", layout.description, job);
    });
}

Status TextFormat::write(const std::filesystem::path& file, const TriangleMesh& geometry,
                         const WriteOptions& options, const JobControl& control) const {
    return writeAtomically(file, [&](AtomicFile& target) {
        const PointCloud& cloud = geometry.vertices;
        const std::string_view separator = separatorFor(file);
        const int decimals = coordinateDecimals(cloud, options.source);
        std::vector<PointColumn> columns = pointColumns(cloud, SourceGrid(options.source));
        std::string text;
        if (file.extension() == ".pts") {
            keepPtsColumns(columns);
            text = std::to_string(cloud.size()) + "\n";
        } else {
            text = separator == "," ? "" : "# ";
            for (const PointColumn& column : columns)
                text += (&column == columns.data() ? "" : std::string(separator)) + column.name;
            text += "\n";
        }
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            stepWriting(control, i, cloud.size());
            for (const PointColumn& column : columns) {
                if (&column != columns.data()) text += separator;
                text += cellText(column, i, decimals);
            }
            text += '\n';
            if (text.size() > 1 << 16) {
                target.write(text);
                text.clear();
            }
        }
        target.write(text);
    });
}

}  // namespace vestige
