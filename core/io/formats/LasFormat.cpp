#include "core/io/formats/LasFormat.h"

#include <algorithm>

#include "core/io/Describe.h"
#include "core/io/LasWriter.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/Copc.h"
#include "core/io/formats/LasCrs.h"
#include "core/io/formats/LasSource.h"

namespace vestige {
namespace {

/// What the header says, and how it agrees with the points' bounds, already in `info`.
void describeHeader(const LasHeader& header, ReadJob& job, FileInfo& info, bool wholeFile = true) {
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
    if (info.points > 0 && wholeFile) {
        const Eigen::Vector3d tolerance = 2 * header.scale.cwiseAbs();
        const bool agree =
            ((info.bounds.min - header.bounds.min).cwiseAbs().array() <= tolerance.array()).all() &&
            ((info.bounds.max - header.bounds.max).cwiseAbs().array() <= tolerance.array()).all();
        if (!agree) job.warn("the bounds in the header are not those of the points");
    }
    info.warnings = std::move(job.warnings());
}

/// What a salvaged file lacks.
std::string damageOf(const LasSource& source, std::uint64_t read, const ReadOptions& options) {
    const LasHeader& header = source.header();
    const bool ended = source.points() < header.promisedPoints || !source.damage().empty();
    if (options.salvage && !ended && source.lacksTable())
        return "the table of the compressed points is missing or damaged; all " +
               counted(header.promisedPoints, "point") + " could be read without it";
    if (!options.salvage || !ended) return {};
    const std::string why =
        source.damage().empty() ? "the file ends early" : "the rest cannot be read: " + source.damage();
    return "of " + std::to_string(header.promisedPoints) + " points " +
           (options.wholeFile() ? "the first " + std::to_string(read) + " are whole and were read; "
                                : "only the first are whole and were read; ") +
           why;
}

/// What of a refused file could be salvaged, offered with the refusal.
void offerWhatIsWhole(std::span<const std::byte> file, const ReadJob& refused, Error& error) {
    if (error.code != ErrorCode::input) return;
    try {
        ReadJob job(refused.path(), {});
        const LasHeader header = parseLasHeader(file, job, true);
        LasSource source(file, header, job, true, true);
        // What is compressed shows its damage only to who decodes it.
        const std::uint64_t points =
            header.compressed
                ? source.read(source.ranges(), [](std::size_t, std::uint64_t, std::span<const LasPoint>) {})
                : source.points();
        if (points > 0) offerSalvage(error, firstOf(points, header.promisedPoints, "point"));
    } catch (const ErrorException&) {
        // Nothing of it can be read: the refusal says why.
    }
}

/// All that options want of a file.
LoadedGeometry readAsWanted(std::span<const std::byte> file, const ReadOptions& options, ReadJob& job) {
    const LasHeader header = parseLasHeader(file, job, options.salvage);
    const bool drawn = options.attributes == ReadOptions::Attributes::drawn;
    LasSource source(file, header, job, drawn, options.salvage);
    std::vector<LasRange> ranges = source.ranges();
    if (options.box)
        if (const auto nodes = copcNodes(file, header, job)) ranges = rangesTouching(*nodes, *options.box);
    LoadedGeometry result;
    result.geometry.vertices = gatherLas(source, ranges, options, job);
    // Damage in a file of one chunk leaves nothing that is sure.
    if (options.wholeFile() && result.geometry.vertices.empty() && !source.damage().empty())
        job.refuse(source.damage(), "a chunk of points that is whole");
    describeGeometry(result.geometry, result.info);
    if (drawn) {
        const LasPointLayout& layout = lasPointLayout(header.pointFormat);
        result.info.attributes = lasAttributes(layout, layout.gpsTime != 0);
    }
    describeHeader(header, job, result.info, options.wholeFile());
    result.info.damage = damageOf(source, result.geometry.vertices.size(), options);
    result.heeded = true;
    return result;
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
        LasSource source(content->bytes(), header, job, false, false);
        const std::vector<LasRange> ranges = source.ranges();
        std::vector<LasSummary> parts(ranges.size());
        source.read(ranges, [&](std::size_t range, std::uint64_t, std::span<const LasPoint> points) {
            for (const LasPoint& point : points) parts[range].add(header, point);
        });
        LasSummary summary;
        for (const LasSummary& part : parts) summary.add(part);
        FileInfo info;
        summary.describe(header, info);
        const auto nodes = copcNodes(content->bytes(), header, job);
        describeHeader(header, job, info);
        if (nodes) info.version += ", COPC of " + counted(nodes->size(), "node");
        return info;
    });
}

Result<FileInfo> LasFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        // Whoever salvages the file looks first; whether it is whole is told when it is read.
        const LasHeader header = parseLasHeader(content->bytes(), job, true);
        FileInfo info;
        const LasPointLayout& layout = lasPointLayout(header.pointFormat);
        info.attributes = lasAttributes(layout, layout.gpsTime != 0);
        describeHeader(header, job, info);
        info.points = header.points;
        if (header.points < header.promisedPoints)
            info.damage = "the file is cut off: there is room for " + std::to_string(header.points) +
                          " of the " + counted(header.promisedPoints, "point") + " that its header names";
        if (header.bounds.min.allFinite() && header.bounds.max.allFinite()) info.bounds = header.bounds;
        return info;
    });
}

Result<std::optional<LoadedGeometry>> LasFormat::preview(const std::filesystem::path& file,
                                                         std::size_t points,
                                                         const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<std::optional<LoadedGeometry>> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const LasHeader header = parseLasHeader(content->bytes(), job);
        LasSource source(content->bytes(), header, job, true, false);
        ReadOptions options;
        options.attributes = ReadOptions::Attributes::drawn;
        const auto nodes = copcNodes(content->bytes(), header, job);
        LoadedGeometry result;
        result.geometry.vertices =
            gatherLas(source, nodes ? coarseRanges(*nodes, points) : source.sample(points), options, job);
        describeGeometry(result.geometry, result.info);
        describeHeader(header, job, result.info, false);
        result.heeded = true;
        return std::optional(std::move(result));
    });
}

Result<LoadedGeometry> LasFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        try {
            return readAsWanted(content->bytes(), options, job);
        } catch (ErrorException& refusal) {
            if (!options.salvage) offerWhatIsWhole(content->bytes(), job, refusal.error);
            throw;
        }
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
