#include <Eigen/SVD>
#include <algorithm>
#include <array>

#include "core/base/CleanText.h"
#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/registration/InitialPose.h"

namespace vestige {
namespace {

/// Three points or more span a plane when their second largest principal extent is not negligible.
constexpr double kSmallestSpread = 1e-3;
/// As far from 0 as coordinates of clouds may be.
constexpr double kFarthest = 1e10;

Eigen::Vector3d centroid(std::span<const PointPair> pairs, Eigen::Vector3d PointPair::*side) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const PointPair& pair : pairs) sum += pair.*side;
    return sum / static_cast<double>(pairs.size());
}

bool spansPlane(std::span<const PointPair> pairs, Eigen::Vector3d PointPair::*side,
                const Eigen::Vector3d& middle) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const PointPair& pair : pairs) scatter += (pair.*side - middle) * (pair.*side - middle).transpose();
    const Eigen::Vector3d extents = Eigen::JacobiSVD<Eigen::Matrix3d>(scatter).singularValues();
    return extents[0] > 0 && extents[1] > kSmallestSpread * kSmallestSpread * extents[0];
}

Result<PointPair> pairOf(const CsvRow& row, const std::string& place) {
    static constexpr std::array<const char*, 6> kNames{"tx", "ty", "tz", "sx", "sy", "sz"};
    const std::string line = place + " line " + std::to_string(row.line);
    if (row.cells.size() != kNames.size())
        return fail(ErrorCode::input, "there are " + std::to_string(row.cells.size()) + " cells", line,
                    "expected the six numbers tx,ty,tz,sx,sy,sz");
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = parseReal(row.cells[i]);
        // Also catches what is no number.
        if (!value || !(std::abs(*value) <= kFarthest))
            return fail(ErrorCode::input,
                        std::string(kNames[i]) + " is not a number: '" + cleanText(row.cells[i]) + "'", line,
                        "expected a decimal number with '.', up to 1e10");
        values[i] = *value;
    }
    return PointPair{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
}

Status checkAgreement(std::span<const PointPair> pairs, const PairAlignment& alignment,
                      const Eigen::Vector3d& middle) {
    double squares = 0;
    for (const PointPair& pair : pairs) squares += (pair.target - middle).squaredNorm();
    const double spread = std::sqrt(squares / static_cast<double>(pairs.size()));
    constexpr double kAllowed = 0.25;
    if (alignment.error_m <= kAllowed * spread) return {};
    const auto worst = std::max_element(alignment.residuals_m.begin(), alignment.residuals_m.end());
    return fail(ErrorCode::untrustworthy,
                "the picked pairs contradict each other: laid together as well as they can be, pair " +
                    std::to_string(worst - alignment.residuals_m.begin() + 1) + " is " +
                    fixedText(*worst, 2) + " m off",
                {}, "are two rows in another order, or is the unit of the source another one?");
}

}  // namespace

Result<PairAlignment> alignPairs(std::span<const PointPair> pairs, double metresPerSourceUnit) {
    if (pairs.size() < 3)
        return fail(ErrorCode::input, "a first pose needs three corresponding pairs, there are " +
                                          std::to_string(pairs.size()));
    const Eigen::Vector3d target = centroid(pairs, &PointPair::target);
    const Eigen::Vector3d source = centroid(pairs, &PointPair::source);
    if (!spansPlane(pairs, &PointPair::target, target) || !spansPlane(pairs, &PointPair::source, source))
        return fail(ErrorCode::untrustworthy, "the picked points lie on one line, which leaves a turn open",
                    {}, "pick three points that are well apart and not in a row");
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const PointPair& pair : pairs)
        covariance += (pair.target - target) * (pair.source - source).transpose();
    PairAlignment alignment;
    alignment.targetFromSource.scale = metresPerSourceUnit;
    // The rotation that maximises trace(R' sum t s') is the one nearest to that sum (Umeyama 1991).
    alignment.targetFromSource.pose.linear() = nearestRotation(covariance);
    alignment.targetFromSource.pose.translation() =
        target - alignment.targetFromSource.pose.linear() * (metresPerSourceUnit * source);
    double squares = 0;
    for (const PointPair& pair : pairs) {
        alignment.residuals_m.push_back((pair.target - alignment.targetFromSource * pair.source).norm());
        squares += alignment.residuals_m.back() * alignment.residuals_m.back();
    }
    alignment.error_m = std::sqrt(squares / static_cast<double>(pairs.size() - 2));
    if (const Status agreed = checkAgreement(pairs, alignment, target); !agreed) return fail(agreed.error());
    return alignment;
}

Result<std::vector<PointPair>> readPointPairs(const std::filesystem::path& file) {
    const auto rows = readCsv(file);
    if (!rows) return fail(rows.error());
    const std::string place = file.string();
    const std::vector<std::string> header{"tx", "ty", "tz", "sx", "sy", "sz"};
    if (rows->empty() || rows->front().cells != header)
        return fail(ErrorCode::input, "the header is not tx,ty,tz,sx,sy,sz", place + " line 1",
                    "expected a file of corresponding points, target then source");
    std::vector<PointPair> pairs;
    for (const CsvRow& row : std::span(*rows).subspan(1)) {
        const Result<PointPair> pair = pairOf(row, place);
        if (!pair) return fail(pair.error());
        pairs.push_back(*pair);
    }
    if (pairs.size() < 3)
        return fail(ErrorCode::input, "there are " + std::to_string(pairs.size()) + " pairs", place,
                    "expected three rows or more");
    return pairs;
}

}  // namespace vestige
