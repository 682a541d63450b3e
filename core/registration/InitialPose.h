#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

namespace vestige {

/// One corresponding pair of picked points, each in the unit of its own file.
struct PointPair {
    Eigen::Vector3d target;
    Eigen::Vector3d source;
};

struct PairAlignment {
    Similarity targetFromSource;
    std::vector<double> residuals_m;  ///< |target - targetFromSource * source| of each pair
    /// How far a pair is off in space (RMS), told from the residuals: three times the sum of their squares
    /// over the 3n - 6 degrees of freedom that a pose leaves n pairs.
    double error_m = 0;
};

/// The least-squares rigid pose of three pairs or more for a known scale (Arun et al. 1987, Umeyama 1991).
/// ErrorCode::untrustworthy when the points lie on a line or coincide, or when the pairs contradict each
/// other: their error is over a quarter of their spread. ErrorCode::input for fewer than three pairs.
Result<PairAlignment> alignPairs(std::span<const PointPair> pairs, double metresPerSourceUnit);

/// picks.csv: header `tx,ty,tz,sx,sy,sz`, a pair a row, three rows or more. ErrorCode::input names file and
/// line.
Result<std::vector<PointPair>> readPointPairs(const std::filesystem::path& file);

/// {"pose": [16], "scale": s}. ErrorCode::input names the file and the field.
Result<Similarity> readPoseFile(const std::filesystem::path& file);
/// The text of such a file; the same bits for the same pose.
std::string poseFileText(const Similarity& targetFromSource);
Status writePoseFile(const std::filesystem::path& file, const Similarity& targetFromSource);

/// What unit a scan's coordinates are in, with a sentence for the user that says why.
struct UnitGuess {
    double metresPerUnit = 1;
    bool certain = false;
    std::string reason;
};
/// From the pairs' distance ratio where there are pairs (certain), else what the source's file says of it
/// (`ofFile`, metres per unit: any length),
/// else from the extent and the point spacing of the source against the target: a scan of over 5 times the
/// target's plausible size is in millimetres. Pairs that fit no unit well leave the word to the file. The
/// target has `metresPerTarget` a unit; the pairs' target points are in metres.
UnitGuess guessUnit(const TriangleMesh& target, double metresPerTarget, const TriangleMesh& source,
                    std::span<const PointPair> pairs, std::optional<double> ofFile = std::nullopt);

}  // namespace vestige
