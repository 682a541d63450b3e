#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// What a *.scp (s3m-spec, scp.json.md) says of a cloud.
struct S3mbIndex {
    std::string version;
    bool adds = false;  ///< finer levels are added to the coarser ones, else they replace them
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    bool inDegrees = false;  ///< of the position: longitude, latitude, height
    std::string crs;         ///< as it stands there: "epsg:4490"
    std::vector<std::string> rootTiles;
};

/// Refuses what is no index of a point cloud.
S3mbIndex parseS3mbIndex(std::string_view text, const ReadJob& job);

}  // namespace vestige
