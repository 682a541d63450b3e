#include "core/io/formats/E57Format.h"

#include <cstring>

#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/E57Cloud.h"
#include "core/io/formats/E57Points.h"
#include "core/io/formats/E57Time.h"
#include "core/io/formats/E57Writer.h"

namespace vestige {
namespace {

constexpr std::string_view kSignature = "ASTM-E57";

/// LAS carries a reference system on as its record.
void describeCrs(const std::string& text, FileInfo& info) {
    info.crs = text;
    if (text.find('[') == std::string::npos) return;
    CrsRecord& record = info.crsRecords.emplace_back();
    record.userId = "LASF_Projection";
    record.recordId = 2112;
    record.description = "OGC WKT";
    record.bytes.assign(text.begin(), text.end());
    record.bytes.push_back(0);
}

/// The grid that the points stand on, where they are all of one scan that is not moved.
void describeGrid(const E57Document& document, FileInfo& info) {
    if (document.scans.size() != 1) return;
    const E57Scan& scan = document.scans.front();
    if (scan.info.fileFromScan.matrix() != Eigen::Matrix4d::Identity()) return;
    Eigen::Vector3d scale;
    Eigen::Vector3d offset;
    constexpr std::array kAxes{E57Role::x, E57Role::y, E57Role::z};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t field = scan.find(kAxes[static_cast<std::size_t>(axis)]);
        if (field == scan.fields.size() || scan.fields[field].type != E57Field::Type::integer) return;
        scale[axis] = scan.fields[field].scale;
        offset[axis] = scan.fields[field].offset;
    }
    if (!(scale.array() > 0).all()) return;
    info.scale = scale;
    info.offset = offset;
}

void describe(const E57Document& document, FileInfo& info) {
    info.format = "E57";
    info.version = "1.0";
    info.metresPerUnit = 1;
    info.attributes = E57Attributes(document).names();
    info.generatingSoftware = document.library;
    info.images = document.images;
    if (document.creation) info.creationDayYear = dayYearOfGps(*document.creation);
    for (const E57Scan& scan : document.scans) {
        info.scans.push_back(scan.info);
        info.gpsTimeIsAdjustedStandard |=
            scan.has(E57Role::time) && e57TimeIsAdjustedStandard(scan.timeStart);
    }
    describeCrs(document.coordinateMetadata, info);
    describeGrid(document, info);
}

}  // namespace

bool E57Format::recognises(std::span<const std::byte> head, std::string_view) const {
    return head.size() >= kSignature.size() &&
           std::memcmp(head.data(), kSignature.data(), kSignature.size()) == 0;
}

Result<FileInfo> E57Format::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const E57Pages pages(content->bytes(), true, job);
        const E57Document document = readE57Document(pages, job);
        FileInfo info;
        info.path = file;
        describe(document, info);
        for (const E57Scan& scan : document.scans) {
            info.points += scan.records;
            if (!scan.bounds.empty())
                info.bounds.add(scan.bounds.transformed(Similarity{scan.info.fileFromScan, 1}));
        }
        info.warnings = std::move(job.warnings());
        return info;
    });
}

Result<std::optional<LoadedGeometry>> E57Format::preview(const std::filesystem::path& file,
                                                         std::size_t points,
                                                         const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<std::optional<LoadedGeometry>> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const E57Pages pages(content->bytes(), false, job);
        const E57Document document = readE57Document(pages, job);
        std::optional<PointCloud> some = previewE57Points(pages, document, points, job);
        if (!some) return std::nullopt;
        LoadedGeometry result = loaded({std::move(*some), {}}, "E57", "1.0", job);
        describe(document, result.info);
        result.heeded = true;
        return result;
    });
}

Result<LoadedGeometry> E57Format::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        E57Pages pages(content->bytes(), options.salvage, job);
        pages.checkAll(job);
        E57Document document = readE57Document(pages, job);
        std::string damage;
        TriangleMesh points{readE57Points(pages, document, options, damage, job), {}};
        LoadedGeometry result = loaded(std::move(points), "E57", "1.0", job);
        describe(document, result.info);
        // Also where it lies beside the points: a salvaged file is never shown as a whole one.
        if (damage.empty() && !pages.damage().empty()) damage = pages.damage() + "; all points could be read";
        result.info.damage = std::move(damage);
        result.heeded = true;
        return result;
    });
}

Status E57Format::write(const std::filesystem::path& file, const TriangleMesh& geometry,
                        const WriteOptions& options, const JobControl& control) const {
    return writeE57(file, geometry, options, control);
}

}  // namespace vestige
