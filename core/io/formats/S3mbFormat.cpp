#include "core/io/formats/S3mbFormat.h"

#include <set>

#include "core/base/Numbers.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/PntsPoints.h"
#include "core/io/formats/S3mbIndex.h"
#include "core/io/formats/S3mbStream.h"
#include "core/io/formats/S3mbTile.h"
#include "core/io/formats/TileUri.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestIndex = std::size_t{64} << 20;
constexpr int kDeepest = 64;

class TreeReader {
  public:
    TreeReader(const fs::path& file, const ReadOptions& options, const JobControl& control)
        : options_(options), control_(control), job_(file, control), cloud_(options) {
        std::error_code problem;
        root_ = fs::canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), problem);
    }

    LoadedGeometry readTile() {
        finer_ = Finer::leave;
        readFile(root_ / job_.path().filename(), 0);
        if (left_ > 0)
            job_.warn(counted(left_, "finer tile") + " not read; open the index (*.scp) for the whole cloud");
        return finish();
    }

    LoadedGeometry readIndex() {
        const Result<MappedFile> content = MappedFile::open(job_.path());
        if (!content) throw ErrorException{content.error()};
        if (content->bytes().size() > kLargestIndex)
            refuseS3mb(job_, "the index has " + counted(content->bytes().size(), "byte"),
                       "at most " + std::to_string(kLargestIndex));
        const S3mbIndex index = parseS3mbIndex(content->text(), job_);
        finer_ = index.adds ? Finer::add : Finer::replace;
        if (!index.inDegrees) tilesInCloud_.topRightCorner<3, 1>() = index.position;
        for (const std::string& url : index.rootTiles) follow(url, root_, job_, 0);
        LoadedGeometry loaded = finish();
        if (index.inDegrees)
            loaded.info.warnings.push_back("the cloud stands at longitude " + exactText(index.position.x()) +
                                           ", latitude " + exactText(index.position.y()) + ", height " +
                                           exactText(index.position.z()) + " (" + index.crs +
                                           "); it is read in its own frame there, in metres");
        else
            loaded.info.crs = index.crs;
        return loaded;
    }

  private:
    enum class Finer { leave, add, replace };

    void follow(const std::string& url, const fs::path& folder, const ReadJob& from, int depth) {
        unlessSalvaged([&] {
            if (depth > kDeepest)
                refuseS3mb(from, "the tiles are nested too deep", "at most " + std::to_string(kDeepest));
            const fs::path file = resolveTileUri(url, folder, root_, from);
            if (!seen_.insert(file).second)
                refuseS3mb(from, "the tile '" + file.filename().string() + "' is named a second time",
                           "every file once");
            job_.alsoReads(file);
            readFile(file, depth);
        });
    }

    /// The tile's points, then, its memory given back, those of the finer tiles.
    void readFile(const fs::path& file, int depth) {
        ReadJob job(file, depth == 0 ? control_ : JobControl());
        job_.report(0, 0);
        std::vector<std::string> children;
        {
            const Result<MappedFile> content = MappedFile::open(file);
            if (!content) throw ErrorException{content.error()};
            const S3mbTile tile = parseS3mbTile(content->bytes(), job);
            version_ = tile.version;
            meshes_ += tile.meshes;
            ++tiles_;
            for (const S3mbLod& lod : tile.lods) {
                if (!lod.child.empty()) children.push_back(lod.child);
                if (lod.child.empty() || finer_ != Finer::replace) addPatches(lod, tile, job);
            }
        }
        if (finer_ == Finer::leave)
            left_ += children.size();
        else
            for (const std::string& child : children) follow(child, file.parent_path(), job, depth + 1);
    }

    void addPatches(const S3mbLod& lod, const S3mbTile& tile, ReadJob& job) {
        for (const S3mbPatch& patch : lod.patches)
            for (const std::string& name : patch.skeletons) {
                const auto points = tile.skeletons.find(name);
                if (points == tile.skeletons.end()) continue;
                if (!used_.insert({job.path().string(), name}).second)
                    refuseS3mb(job, "the skeleton '" + name.substr(0, 60) + "' is placed twice",
                               "every point once");
                addPntsPoints(points->second, tilesInCloud_ * patch.tilesFromPatch, cloud_, job);
                notKept_.insert(points->second.notKept.begin(), points->second.notKept.end());
            }
    }

    template <class Work>
    void unlessSalvaged(const Work& work) {
        try {
            work();
        } catch (const ErrorException& thrown) {
            if (!options_.salvage || thrown.error.code != ErrorCode::input) throw;
            damage_.push_back(thrown.error.sentence());
        }
    }

    LoadedGeometry finish() {
        if (tiles_ == 0 && !damage_.empty()) job_.refuse(damage_.front());
        job_.warn("S3M is read by SuperMap's specification alone; compare with an export as LAS or 3D Tiles");
        if (meshes_ > 0) job_.warn(counted(meshes_, "part") + " of lines or surfaces passed over");
        std::string names;
        for (const std::string& name : notKept_) names += (names.empty() ? "" : ", ") + name;
        if (!names.empty()) job_.warn("not kept: " + names);
        LoadedGeometry loaded =
            std::move(cloud_).finish("S3M", version_ + ", " + counted(tiles_, "tile"), job_);
        if (!damage_.empty())
            loaded.info.damage =
                std::to_string(damage_.size()) +
                " of the tiles could not be read, their points are missing: " + damage_.front();
        return loaded;
    }

    const ReadOptions& options_;
    const JobControl& control_;
    ReadJob job_;
    TileCloud cloud_;
    fs::path root_;
    Finer finer_ = Finer::leave;
    Eigen::Matrix4d tilesInCloud_ = Eigen::Matrix4d::Identity();
    std::set<fs::path> seen_;
    std::set<std::pair<std::string, std::string>> used_;
    std::set<std::string> notKept_;
    std::vector<std::string> damage_;
    std::string version_ = "3";
    std::size_t tiles_ = 0, meshes_ = 0, left_ = 0;
};

bool isIndex(const fs::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension != ".s3mb";
}

}  // namespace

bool S3mbFormat::recognises(std::span<const std::byte>, std::string_view extension) const {
    return extension == "scp" || extension == "s3mb";
}

Result<LoadedGeometry> S3mbFormat::read(const fs::path& file, const ReadOptions& options,
                                        const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        TreeReader reader(file, options, control);
        return isIndex(file) ? reader.readIndex() : reader.readTile();
    });
}

}  // namespace vestige
