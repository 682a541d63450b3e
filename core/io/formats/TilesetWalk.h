#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// A point tile that a tileset names.
struct TilesetTile {
    std::filesystem::path file;
    Eigen::Matrix4d rootFromTile;  ///< affine: the transforms from the root down to it
};

/// What a tileset and those that it nests hold.
struct TilesetContents {
    std::vector<TilesetTile> tiles;              ///< to be read, in the order of the tree
    std::string version;                         ///< of the asset: "1.0", "1.1"
    bool hasRegions = false;                     ///< bounding volumes in longitude and latitude
    std::size_t replaced = 0;                    ///< coarser point tiles left out
    std::map<std::string, std::size_t> notRead;  ///< contents of other kinds, by kind
    std::vector<std::string> unreadable;         ///< when salvaging: sentences
};

/// Walks over the tree of a tileset.json (3D Tiles 1.0 and 1.1), nested tilesets in their places. Of tiles
/// that refine by REPLACE only the finest are taken: a tile whose descendants hold points is left out.
/// The nested tilesets are named to the job as read. Contents stay inside the folder of `file` and are named
/// once each, so that the work is bounded by the files that are there. Refuses implicit tiling, transforms
/// that are no affine 4 x 4 matrix, and tiles that are missing; the last, when salvaging, are listed.
TilesetContents walkTileset(const std::filesystem::path& file, bool salvage, ReadJob& job);

}  // namespace vestige
