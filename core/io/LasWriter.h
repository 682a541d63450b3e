#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"
#include "core/geometry/PointSet.h"
#include "core/io/FileInfo.h"

namespace vestige {

/// One cloud of a LAS file with several: its points as they are after `worldFromCloud`, in input order.
struct LasPart {
    const PointCloud* cloud = nullptr;
    Similarity worldFromCloud;
    std::uint16_t pointSource = 0;
    /// Gets the same points, in the same order, with attributes that `cloud` lacks, when their turn has come;
    /// they are dropped once written. Empty: `cloud` has all.
    std::function<Result<std::shared_ptr<const PointCloud>>(const JobControl&)> complete = {};
    const PointSet* withheld = nullptr;  ///< points that get the flag of that name; null: none
};

struct LasWriteOptions {
    std::optional<Eigen::Vector3d> scale;   ///< default 0.0001 (0.1 mm)
    std::optional<Eigen::Vector3d> offset;  ///< default: bounds' centre rounded to whole metres
    std::vector<CrsRecord> crsRecords;
    bool gpsTimeIsAdjustedStandard = false;
    int creationDay = 0;
    int creationYear = 0;
    std::array<std::uint8_t, 16> guid{};
    std::vector<CrsRecord> extraRecords;  ///< further VLRs, e.g. the names of the layers
    bool keepPointSource = false;         ///< the clouds' own IDs instead of LasPart::pointSource
};

/// Writes LAS 1.4 (LAZ when the extension is .laz), atomically, part after part. The point format is the
/// smallest of 6, 7 (colour), that holds the parts' attributes. ErrorCode::output on failure.
Status writeLas(const std::filesystem::path& file, const std::vector<LasPart>& parts,
                const LasWriteOptions& options, const JobControl& control = {});

}  // namespace vestige
