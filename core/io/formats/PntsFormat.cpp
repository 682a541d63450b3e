#include "core/io/formats/PntsFormat.h"

#include "core/io/MappedFile.h"
#include "core/io/formats/PntsDraco.h"
#include "core/io/formats/PntsPoints.h"

namespace vestige {
namespace {

std::string versionText(const PntsTables& tables) {
    if (tables.draco) return "1, Draco";
    return tables.feature("POSITION") ? "1" : "1, quantised";
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

}  // namespace

bool PntsFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    return head.size() >= 4 && textOf(head, {0, 4}) == "pnts";
}

Result<FileInfo> PntsFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const PntsHeader header = parsePntsHeader(content->bytes(), true, job);
        const PntsTables tables = parsePntsTables(content->bytes(), header, true, job);
        FileInfo info;
        info.path = file;
        info.format = "PNTS";
        info.version = versionText(tables);
        info.points = tables.points;
        info.metresPerUnit = 1;
        info.attributes = tables.attributes().names();
        return info;
    });
}

Result<LoadedGeometry> PntsFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                        const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const PntsHeader header = parsePntsHeader(content->bytes(), options.salvage, job);
        PntsTables tables = parsePntsTables(content->bytes(), header, options.salvage, job);
        decodeDraco(content->bytes(), tables, job);
        TileCloud cloud(options);
        addPntsPoints(tables, Eigen::Matrix4d::Identity(), cloud, job);
        if (!tables.notKept.empty()) job.warn("not kept: " + listed(tables.notKept));
        LoadedGeometry result = std::move(cloud).finish("PNTS", versionText(tables), job);
        result.info.damage = tables.damage;
        return result;
    });
}

}  // namespace vestige
