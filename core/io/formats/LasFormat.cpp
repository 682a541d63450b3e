#include "core/io/formats/LasFormat.h"

#include <algorithm>

#include "core/io/Describe.h"
#include "core/io/LasWriter.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/LasCrs.h"
#include "core/io/formats/LazReader.h"

namespace vestige {
namespace {

/// A file may promise what it does not hold; memory for more than this comes as points come.
constexpr std::uint64_t kMostReserved = 1 << 20;

void readPoints(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job,
                const LasPointHandler& handle) {
    if (header.compressed)
        readLazPoints(file, header, job, handle);
    else
        readLasPoints(file, header, job, handle);
}

/// What the header says, and how it agrees with the points' bounds, already in `info`.
void describeHeader(const LasHeader& header, ReadJob& job, FileInfo& info) {
    info.path = job.path();
    info.format = header.compressed ? "LAZ" : "LAS";
    info.version =
        "1." + std::to_string(header.versionMinor) + ", point format " + std::to_string(header.pointFormat);
    info.scale = header.scale;
    info.offset = header.offset;
    info.crsRecords = crsRecords(header);
    info.crs = crsText(info.crsRecords, job);
    info.gpsTimeIsAdjustedStandard = (header.globalEncoding & 1) != 0;
    info.creationDayYear = {header.creationDay, header.creationYear};
    info.generatingSoftware = header.generatingSoftware;
    if (info.points > 0) {
        const Eigen::Vector3d tolerance = 2 * header.scale.cwiseAbs();
        const bool agree =
            ((info.bounds.min - header.bounds.min).cwiseAbs().array() <= tolerance.array()).all() &&
            ((info.bounds.max - header.bounds.max).cwiseAbs().array() <= tolerance.array()).all();
        if (!agree) job.warn("the bounds in the header are not those of the points");
    }
    info.warnings = std::move(job.warnings());
}

}  // namespace

bool LasFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    constexpr std::string_view kSignature = "LASF";
    return head.size() >= kSignature.size() &&
           std::equal(kSignature.begin(), kSignature.end(), head.begin(),
                      [](char c, std::byte byte) { return static_cast<std::byte>(c) == byte; });
}

Result<FileInfo> LasFormat::info(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const LasHeader header = parseLasHeader(content->bytes(), job);
        LasSummary summary;
        readPoints(content->bytes(), header, job, [&](const LasPoint& point) { summary.add(point); });
        FileInfo info;
        summary.describe(header, info);
        describeHeader(header, job, info);
        return info;
    });
}

Result<LoadedGeometry> LasFormat::read(const std::filesystem::path& file, const ReadOptions& /*options*/,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const LasHeader header = parseLasHeader(content->bytes(), job);
        LasCloud cloud(header);
        cloud.reserve(std::min(header.points, header.compressed ? kMostReserved : header.points));
        readPoints(content->bytes(), header, job, [&](const LasPoint& point) { cloud.add(point); });
        LoadedGeometry result;
        result.geometry.vertices = std::move(cloud).build(job);
        describeGeometry(result.geometry, result.info);
        describeHeader(header, job, result.info);
        return result;
    });
}

Status LasFormat::write(const std::filesystem::path& file, const TriangleMesh& geometry,
                        const WriteOptions& options, const JobControl& control) const {
    LasWriteOptions las;
    if (const FileInfo* source = options.source) {
        las.scale = source->scale;
        las.offset = source->offset;
        las.crsRecords = source->crsRecords;
        las.gpsTimeIsAdjustedStandard = source->gpsTimeIsAdjustedStandard;
        if (source->creationDayYear) {
            las.creationDay = source->creationDayYear->first;
            las.creationYear = source->creationDayYear->second;
        }
    }
    las.keepPointSource = true;
    return writeLas(file, {{&geometry.vertices, Similarity{}, 0}}, las, control);
}

}  // namespace vestige
