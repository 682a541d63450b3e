#include "core/io/formats/TilesetFormat.h"

#include <set>

#include "core/io/LooksLikeTileset.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/PntsDraco.h"
#include "core/io/formats/PntsPoints.h"
#include "core/io/formats/TilesetWalk.h"

namespace vestige {
namespace {

constexpr std::size_t kMostPoints = 0xffffffff;
// The Earth's surface, mountains, mines and the flattening included.
constexpr double kLeastRadius_m = 6.3e6;
constexpr double kLargestRadius_m = 6.4e6;

/// What the tiles had to say, each thing once.
class Notes {
  public:
    void add(const PntsTables& tables, const ReadJob& tile, std::vector<std::string>& warnings) {
        notKept_.insert(tables.notKept.begin(), tables.notKept.end());
        for (const std::string& warning : warnings)
            if (others_++ == 0) firstOther_ = tile.path().filename().string() + ": " + warning;
        if (!tables.damage.empty()) damaged_.push_back(tile.place() + ": " + tables.damage);
    }
    void damaged(const std::string& sentence) { damaged_.push_back(sentence); }
    const std::vector<std::string>& damage() const { return damaged_; }

    void tell(ReadJob& job) const {
        std::string names;
        for (const std::string& name : notKept_) names += (names.empty() ? "" : ", ") + name;
        if (!names.empty()) job.warn("not kept: " + names);
        if (others_ > 0)
            job.warn(firstOther_ +
                     (others_ > 1 ? " (and " + counted(others_ - 1, "like note") + " of other tiles)" : ""));
    }

  private:
    std::set<std::string> notKept_;
    std::vector<std::string> damaged_;
    std::string firstOther_;
    std::size_t others_ = 0;
};

std::string damageText(const std::vector<std::string>& sentences, std::size_t tiles) {
    if (sentences.empty()) return {};
    return std::to_string(sentences.size()) +
           " of the tiles could not be read whole, their points are missing (" + counted(tiles, "tile") +
           " named): " + sentences.front();
}

void tellWhatIsLeftOut(const TilesetContents& contents, ReadJob& job) {
    for (const auto& [kind, count] : contents.notRead)
        job.warn(counted(count, "tile") + " of the kind " + kind + " passed over; only point tiles are read");
    if (contents.replaced > 0)
        job.warn(counted(contents.replaced, "coarser tile") + " left out, since finer ones replace them");
}

std::string versionText(const TilesetContents& contents) {
    return (contents.version.empty() ? "" : contents.version + ", ") + counted(contents.tiles.size(), "tile");
}

/// Only regions are certain to mean Earth-centred coordinates (3D Tiles 1.0, "Coordinate reference system"),
/// and only where the points agree.
std::string crsOf(const TilesetContents& contents, const BoundingBox& bounds) {
    if (!contents.hasRegions || bounds.empty()) return {};
    const double radius = bounds.centre().norm();
    if (radius < kLeastRadius_m || radius > kLargestRadius_m) return {};
    return "EPSG:4978 (ECEF, WGS 84), as the tileset's regions say";
}

void requireTiles(const TilesetContents& contents, const ReadJob& job) {
    if (!contents.tiles.empty()) return;
    if (!contents.unreadable.empty()) job.refuse(contents.unreadable.front());
    job.refuse("the tileset names no point tiles",
               contents.notRead.empty()
                   ? "contents of the kind pnts"
                   : "contents of the kind pnts, not " + contents.notRead.begin()->first);
}

class TilesReader {
  public:
    TilesReader(const ReadOptions& options, const JobControl& control)
        : options_(options), control_(control), cloud_(options) {}

    void read(const TilesetTile& tile, double from, double to) {
        ReadJob job(tile.file, control_.sub(from, to));
        job.report(0, 0);
        try {
            const Result<MappedFile> content = MappedFile::open(tile.file);
            if (!content) throw ErrorException{content.error()};
            const PntsHeader header = parsePntsHeader(content->bytes(), options_.salvage, job);
            PntsTables tables = parsePntsTables(content->bytes(), header, options_.salvage, job);
            if (tables.points > kMostPoints - cloud_.size())
                job.refuse("the tiles hold more points than Vestige can number",
                           "at most " + std::to_string(kMostPoints));
            decodeDraco(content->bytes(), tables, job);
            addPntsPoints(tables, tile.rootFromTile, cloud_, job);
            notes_.add(tables, job, job.warnings());
        } catch (const ErrorException& thrown) {
            if (!options_.salvage || thrown.error.code != ErrorCode::input) throw;
            notes_.damaged(thrown.error.sentence());
        }
    }

    TileCloud& cloud() { return cloud_; }
    Notes& notes() { return notes_; }

  private:
    const ReadOptions& options_;
    JobControl control_;
    TileCloud cloud_;
    Notes notes_;
};

}  // namespace

bool TilesetFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    return looksLikeTilesetText({reinterpret_cast<const char*>(head.data()), head.size()});
}

Result<FileInfo> TilesetFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        ReadJob job(file, control);
        const TilesetContents contents = walkTileset(file, true, job);
        FileInfo info;
        info.path = file;
        info.format = "3D Tiles";
        info.version = versionText(contents);
        info.metresPerUnit = 1;
        TileAttributes any;
        for (std::size_t i = 0; i < contents.tiles.size(); ++i) {
            job.report(i, contents.tiles.size());
            const Result<MappedFile> content = MappedFile::open(contents.tiles[i].file);
            if (!content) continue;
            ReadJob tile(contents.tiles[i].file, {});
            try {
                const PntsHeader header = parsePntsHeader(content->bytes(), true, tile);
                const PntsTables tables = parsePntsTables(content->bytes(), header, true, tile);
                info.points += tables.points;
                any.add(tables.attributes());
            } catch (const ErrorException& broken) {
                // It is told when the tile is read; whoever salvages does without it.
                if (broken.error.code != ErrorCode::input) throw;
            }
        }
        info.attributes = any.names();
        return info;
    });
}

Result<LoadedGeometry> TilesetFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                           const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        ReadJob job(file, control);
        const TilesetContents contents = walkTileset(file, options.salvage, job);
        requireTiles(contents, job);
        for (const TilesetTile& tile : contents.tiles) job.alsoReads(tile.file);
        TilesReader reader(options, control);
        for (const std::string& sentence : contents.unreadable) reader.notes().damaged(sentence);
        const double count = static_cast<double>(contents.tiles.size());
        for (std::size_t i = 0; i < contents.tiles.size(); ++i)
            reader.read(contents.tiles[i], static_cast<double>(i) / count,
                        static_cast<double>(i + 1) / count);
        reader.notes().tell(job);
        tellWhatIsLeftOut(contents, job);
        LoadedGeometry result = std::move(reader.cloud()).finish("3D Tiles", versionText(contents), job);
        result.info.crs = crsOf(contents, result.info.bounds);
        result.info.damage =
            damageText(reader.notes().damage(), contents.tiles.size() + contents.unreadable.size());
        return result;
    });
}

}  // namespace vestige
