#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/io/formats/PntsTables.h"

namespace vestige {

/// A piece of a level of detail: skeletons, by name, in a place.
struct S3mbPatch {
    Eigen::Matrix4d tilesFromPatch;
    std::vector<std::string> skeletons;
};

struct S3mbLod {
    std::string child;  ///< the file with the finer level, relative to this one; empty at the finest
    std::vector<S3mbPatch> patches;
};

/// An unpacked *.s3mb. The arrays of the skeletons point into `bytes`.
struct S3mbTile {
    std::string version;  ///< "3.01"
    std::vector<std::byte> bytes;
    std::vector<S3mbLod> lods;
    std::map<std::string, PntsTables> skeletons;  ///< those of points
    std::size_t meshes = 0;                       ///< skeletons of lines and surfaces, left out
};

/// Reads a tile by SuperMap's specification (github.com/SuperMap/s3m-spec, Specification/S3MB, version 3.0
/// and 3.01; where its text and its published SDK differ, as the SDK). Refuses what is not understood.
S3mbTile parseS3mbTile(std::span<const std::byte> file, ReadJob& job);

}  // namespace vestige
