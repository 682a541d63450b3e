#include "core/io/formats/TilesetWalk.h"

#include <Eigen/LU>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/JsonSize.h"
#include "core/io/LooksLikeTileset.h"
#include "core/io/MappedFile.h"
#include "core/io/TextScanner.h"
#include "core/io/formats/JsonPart.h"
#include "core/io/formats/TileUri.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargestIndex = std::size_t{64} << 20;
constexpr std::size_t kMostValues = std::size_t{6} << 20;  // of a tileset and those that nest it, together
constexpr int kDeepestNesting = 32;
constexpr int kDeepestTile = 256;  // those of nested tilesets counted with those that nest them

/// Of one tileset.json, while its tree is walked.
struct Index {
    fs::path file;
    ReadJob job;
    int nesting = 0;
};

/// A tile's place in its tileset: "root.children[3]".
struct Place {
    const Index& index;
    std::string path;

    [[noreturn]] void refuse(std::string message, const std::string& expected) const {
        throw ErrorException{{ErrorCode::input, std::move(message), index.file.string() + ", " + path,
                              "expected: " + expected}};
    }
};

const json* at(const json& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

const json* extensionOf(const json& tile, const char* name) {
    const json* extensions = at(tile, "extensions");
    return extensions ? at(*extensions, name) : nullptr;
}

Eigen::Matrix4d transformOf(const json& tile, const Place& place) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    const json* values = at(tile, "transform");
    if (!values) return matrix;
    if (!values->is_array() || values->size() != 16 ||
        !std::all_of(values->begin(), values->end(), [](const json& value) { return value.is_number(); }))
        place.refuse("the transform is no matrix", "16 numbers, column after column");
    for (std::size_t i = 0; i < 16; ++i)
        matrix(static_cast<int>(i % 4), static_cast<int>(i / 4)) = (*values)[i].get<double>();
    if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1) ||
        matrix.topLeftCorner<3, 3>().determinant() == 0)
        place.refuse("the transform is not affine and invertible", "a matrix whose last row is 0 0 0 1");
    return matrix;
}

/// The contents of a tile in the order in which they stand there, however they are written.
std::vector<const json*> contentsOf(const json& tile) {
    std::vector<const json*> contents;
    if (const json* content = at(tile, "content")) contents.push_back(content);
    const json* several = at(tile, "contents");
    if (const json* extension = extensionOf(tile, "3DTILES_multiple_contents"))
        several = at(*extension, "contents") ? at(*extension, "contents") : at(*extension, "content");
    if (several && several->is_array())
        for (const json& content : *several) contents.push_back(&content);
    return contents;
}

bool hasRegion(const json& object) {
    const json* volume = at(object, "boundingVolume");
    return volume && at(*volume, "region");
}

enum class Kind { points, tileset, other };

Kind kindOf(const fs::path& file, std::string& name, const ReadJob& job) {
    char head[64] = {};
    std::ifstream stream(file, std::ios::binary);
    stream.read(head, sizeof head);
    const std::string_view text(head, static_cast<std::size_t>(stream.gcount()));
    name = text.substr(0, 4);
    if (name == "pnts") return Kind::points;
    for (const char* known : {"b3dm", "i3dm", "cmpt", "glTF", "vctr", "geom", "subt"})
        if (name == known) return Kind::other;
    const std::string_view begin = trimmed(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text);
    if (!begin.starts_with("{"))
        throw ErrorException{{ErrorCode::input, "this is no tile of a known kind", file.string() + ", byte 0",
                              "expected: \"pnts\", named by " + job.place()}};
    name = "glTF";
    return looksLikeTileset(file) ? Kind::tileset : Kind::other;
}

class Walker {
  public:
    Walker(const fs::path& root, bool salvage, ReadJob& job) : root_(root), salvage_(salvage), job_(job) {}

    TilesetContents walk(const fs::path& file) {
        seen_.insert(file);
        walkFile(file, Eigen::Matrix4d::Identity(), "REPLACE", 0);
        return std::move(contents_);
    }

  private:
    /// True when there are points in it.
    bool walkFile(const fs::path& file, const Eigen::Matrix4d& rootFromFile, const std::string& refine,
                  int nesting) {
        Index index{file, ReadJob(file, {}), nesting};
        if (nesting > 0) job_.alsoReads(file);
        if (nesting > kDeepestNesting)
            index.job.refuse("the tilesets are nested too deep",
                             "at most " + std::to_string(kDeepestNesting) + " in each other");
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) throw ErrorException{content.error()};
        if (content->bytes().size() > kLargestIndex)
            index.job.refuse("the tileset has " + counted(content->bytes().size(), "byte"),
                             "at most " + std::to_string(kLargestIndex) + ", larger ones nested");
        const std::size_t left = values_;
        JsonLimits limits;
        limits.values = left;
        const json tree = parseJsonObject(content->text(), 0, limits, index.job);
        values_ -= jsonSize(content->text()).values;
        const json* asset = at(tree, "asset");
        const json* top = at(tree, "root");
        if (at(tree, "vestige"))
            index.job.refuse("this is a Vestige case, no cloud", "a point cloud, a mesh or a tileset");
        if (!asset || !top || !top->is_object())
            index.job.refuse("this JSON is no tileset of 3D Tiles", "the keys \"asset\" and \"root\"");
        if (const json* version = at(*asset, "version"); version && version->is_string() && nesting == 0)
            contents_.version = version->get<std::string>().substr(0, 20);
        if (nesting == 0 && !at(*top, "refine") && at(*top, "children"))
            job_.warn("the tileset does not say how its tiles refine each other; REPLACE is assumed");
        const bool points = walkTile(*top, rootFromFile, refine, {index, "root"});
        values_ = left;
        return points;
    }

    bool walkTile(const json& tile, const Eigen::Matrix4d& rootFromParent, const std::string& parentRefine,
                  const Place& place) {
        if (++depth_ > kDeepestTile)
            place.refuse("the tiles are nested too deep",
                         "at most " + std::to_string(kDeepestTile) + " in each other");
        const bool points = walkWhatItHolds(tile, rootFromParent, parentRefine, place);
        --depth_;
        return points;
    }

    bool walkWhatItHolds(const json& tile, const Eigen::Matrix4d& rootFromParent,
                         const std::string& parentRefine, const Place& place) {
        job_.report(0, 0);
        if (!tile.is_object()) place.refuse("the tile is no object", "{ ... }");
        if (at(tile, "implicitTiling") || extensionOf(tile, "3DTILES_implicit_tiling"))
            place.refuse("the tiles are divided implicitly, which Vestige does not read",
                         "tiles that are listed; export the cloud as LAS, or as 3D Tiles 1.0");
        const Eigen::Matrix4d rootFromTile = rootFromParent * transformOf(tile, place);
        const std::string refine = refineOf(tile, parentRefine, place);
        contents_.hasRegions |= hasRegion(tile);
        const std::size_t begin = contents_.tiles.size();
        std::vector<fs::path> nested;
        for (const json* content : contentsOf(tile)) addContent(*content, rootFromTile, nested, place);
        const std::size_t own = contents_.tiles.size() - begin;

        bool below = false;
        for (const fs::path& file : nested)
            below |=
                unlessSalvaged([&] { return walkFile(file, rootFromTile, refine, place.index.nesting + 1); });
        if (const json* children = at(tile, "children")) {
            if (!children->is_array()) place.refuse("the children are no list", "[ ... ]");
            for (std::size_t i = 0; i < children->size(); ++i)
                below |= walkTile((*children)[i], rootFromTile, refine,
                                  {place.index, place.path + ".children[" + std::to_string(i) + "]"});
        }
        if (below && refine == "REPLACE" && own > 0) {
            const auto first = contents_.tiles.begin() + static_cast<std::ptrdiff_t>(begin);
            contents_.tiles.erase(first, first + static_cast<std::ptrdiff_t>(own));
            contents_.replaced += own;
        }
        return below || own > 0;
    }

    static std::string refineOf(const json& tile, const std::string& inherited, const Place& place) {
        const json* refine = at(tile, "refine");
        if (!refine) return inherited;
        const std::string name = refine->is_string() ? refine->get<std::string>() : std::string();
        if (equalsIgnoringCase(name, "add")) return "ADD";
        if (equalsIgnoringCase(name, "replace")) return "REPLACE";
        place.refuse("the tile refines by '" + name.substr(0, 40) + "'", "ADD or REPLACE");
    }

    void addContent(const json& content, const Eigen::Matrix4d& rootFromTile, std::vector<fs::path>& nested,
                    const Place& place) {
        contents_.hasRegions |= hasRegion(content);
        const json* uri = at(content, "uri");
        if (!uri) uri = at(content, "url");
        if (!uri || !uri->is_string()) place.refuse("the content names no file", "a \"uri\"");
        unlessSalvaged([&] {
            const fs::path file = resolveTileUri(uri->get<std::string>(), place.index.file.parent_path(),
                                                 root_, place.index.job);
            if (!seen_.insert(file).second)
                place.refuse("the tile '" + file.filename().string() + "' is named a second time",
                             "every file once");
            std::string kind;
            switch (kindOf(file, kind, place.index.job)) {
                case Kind::points:
                    contents_.tiles.push_back({file, rootFromTile});
                    break;
                case Kind::tileset:
                    nested.push_back(file);
                    break;
                case Kind::other:
                    ++contents_.notRead[kind];
                    break;
            }
            return true;
        });
    }

    /// What `work` says; when salvaging, its refusal becomes a sentence.
    template <class Work>
    bool unlessSalvaged(const Work& work) {
        const std::size_t values = values_;
        const int depth = depth_;
        const std::size_t before = contents_.tiles.size();
        try {
            return work();
        } catch (const ErrorException& thrown) {
            if (!salvage_ || thrown.error.code != ErrorCode::input) throw;
            contents_.unreadable.push_back(thrown.error.sentence());
            values_ = values;
            depth_ = depth;
            return contents_.tiles.size() > before;
        }
    }

    fs::path root_;
    bool salvage_;
    ReadJob& job_;
    TilesetContents contents_;
    std::set<fs::path> seen_;
    std::size_t values_ = kMostValues;
    int depth_ = 0;
};

}  // namespace

TilesetContents walkTileset(const fs::path& file, bool salvage, ReadJob& job) {
    std::error_code problem;
    const fs::path folder =
        fs::canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), problem);
    if (problem) job.refuse("the folder of the tileset cannot be found: " + problem.message(), "a folder");
    return Walker(folder, salvage, job).walk(folder / file.filename());
}

}  // namespace vestige
