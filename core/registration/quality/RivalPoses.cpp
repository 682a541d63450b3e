#include "core/registration/quality/RivalPoses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr double kUpright = 0.2;   // |z| of a wall's normal
constexpr double kFacing = 0.966;  // cosine: 15 degrees
constexpr std::size_t kPeaks = 3;  // along each of the two directions
constexpr std::size_t kRefined = 3;
constexpr double kDrawnIn = 5;  // as far as least squares may draw one, in what counts as apart
constexpr double kAlike = 0.1;  // rad

/// Level unit vector along which most walls face, or its quarter turn: the fourth power makes those one.
Eigen::Vector2d mainFacing(const std::vector<SurfaceCell>& cells) {
    std::complex<double> sum = 0;
    for (const SurfaceCell& cell : cells) {
        if (std::abs(cell.normal.z()) > kUpright) continue;
        const std::complex<double> facing(cell.normal.x(), cell.normal.y());
        const std::complex<double> square = facing * facing;
        sum += cell.area_m2 * square * square;
    }
    const auto root = [](std::complex<double> z) {  // of a unit number, right half plane
        const double real = std::sqrt(std::max(0.0, (1 + z.real()) / 2));
        const double imaginary = std::sqrt(std::max(0.0, (1 - z.real()) / 2));
        return std::complex<double>(real, z.imag() < 0 ? -imaginary : imaginary);
    };
    const double length = std::sqrt(std::norm(sum));
    if (!(length > 0)) return Eigen::Vector2d::UnitX();
    const std::complex<double> facing = root(root(sum / length));
    return {facing.real(), facing.imag()};
}

/// Wall area by its place along a direction.
struct WallProfile {
    double first_m = 0;
    std::vector<double> areas;
};

WallProfile profile(const std::vector<SurfaceCell>& cells, const Pose& pose, const Eigen::Vector3d& along,
                    double bin_m) {
    double low = 1e300, high = -1e300;
    for (const SurfaceCell& cell : cells) {
        const double place = along.dot(pose * cell.mean);
        low = std::min(low, place);
        high = std::max(high, place);
    }
    constexpr double kMostBins = 4096;
    WallProfile walls{std::floor(low / bin_m) * bin_m, {}};
    walls.areas.assign(static_cast<std::size_t>(std::clamp((high - low) / bin_m + 2, 1.0, kMostBins)), 0);
    for (const SurfaceCell& cell : cells) {
        if (std::abs(along.dot(pose.linear() * cell.normal)) < kFacing) continue;
        const auto bin = static_cast<std::size_t>((along.dot(pose * cell.mean) - walls.first_m) / bin_m);
        if (bin < walls.areas.size()) walls.areas[bin] += cell.area_m2;
    }
    return walls;
}

/// The shifts of `moved` along its direction under which most wall area falls on `fixed`, the best first, and
/// no two of them near each other.
std::vector<double> bestShifts(const WallProfile& fixed, const WallProfile& moved, double bin_m) {
    const auto n = static_cast<std::ptrdiff_t>(fixed.areas.size());
    const auto m = static_cast<std::ptrdiff_t>(moved.areas.size());
    std::vector<double> scores(static_cast<std::size_t>(n + m - 1), 0);
    parallelFor(scores.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::ptrdiff_t shift = static_cast<std::ptrdiff_t>(k) - (m - 1);
            for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, -shift); j < std::min(m, n - shift); ++j)
                scores[k] += std::min(fixed.areas[static_cast<std::size_t>(j + shift)],
                                      moved.areas[static_cast<std::size_t>(j)]);
        }
    });
    constexpr std::ptrdiff_t kApart = 4;
    std::vector<double> shifts;
    while (shifts.size() < kPeaks) {
        const auto best = std::max_element(scores.begin(), scores.end());
        if (!(*best > 0)) break;
        const std::ptrdiff_t k = best - scores.begin();
        shifts.push_back(fixed.first_m - moved.first_m + static_cast<double>(k - (m - 1)) * bin_m);
        const auto size = static_cast<std::ptrdiff_t>(scores.size());
        std::fill(scores.begin() + std::max<std::ptrdiff_t>(0, k - kApart),
                  scores.begin() + std::min(size, k + kApart + 1), 0);
    }
    return shifts;
}

}  // namespace

double poseScore(const SurfaceShares& source, const SurfaceShares& target) {
    return source.agrees + target.agrees + source.support + target.support;
}

double poseScore(const SurfaceFit& fit, const Pose& pose) {
    return poseScore(fit.sourceShares(pose), fit.targetShares(pose));
}

std::vector<RivalPose> rivalPoses(const SurfaceFit& fit, const Pose& found, double apart_m) {
    const std::vector<SurfaceCell>& fixed = fit.target().cells();
    const std::vector<SurfaceCell>& moved = fit.source().cells();
    if (fixed.empty() || moved.empty()) return {};
    const Eigen::Vector2d facing = mainFacing(fixed);
    const std::array along{Eigen::Vector3d(facing.x(), facing.y(), 0),
                           Eigen::Vector3d(-facing.y(), facing.x(), 0)};
    const double bin = 2 * fit.tolerance_m();
    const std::array walls{profile(fixed, Pose::Identity(), along[0], bin),
                           profile(fixed, Pose::Identity(), along[1], bin)};
    const Eigen::Vector3d middle = fit.middle(found);
    std::vector<RivalPose> tried;
    for (const auto& [cosine, sine] : {std::pair{1., 0.}, {-1., 0.}, {0., 1.}, {0., -1.}}) {
        Pose turn = Pose::Identity();
        turn.linear() << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
        turn.translation() = middle - turn.linear() * middle;
        const Pose turned = turn * found;
        std::array<std::vector<double>, 2> shifts;
        for (std::size_t axis = 0; axis < 2; ++axis)
            shifts[axis] = bestShifts(walls[axis], profile(moved, turned, along[axis], bin), bin);
        for (const double one : shifts[0])
            for (const double two : shifts[1]) {
                const Pose pose = Eigen::Translation3d(one * along[0] + two * along[1]) * turned;
                if (cosine == 1 && std::hypot(one, two) < apart_m) continue;
                tried.push_back({pose, fit.quickAgreement(pose)});
            }
    }
    std::stable_sort(tried.begin(), tried.end(),
                     [](const RivalPose& a, const RivalPose& b) { return a.score > b.score; });
    if (tried.size() > kRefined) tried.resize(kRefined);
    std::vector<RivalPose> rivals;
    for (const RivalPose& one : tried) {
        const Pose pose = fit.drawnIn(one.pose);
        if ((pose.translation() - one.pose.translation()).norm() > kDrawnIn * apart_m) continue;
        const Pose back = found.inverse() * pose;
        if (back.translation().norm() < apart_m && rotationAngle(back.linear()) < kAlike) continue;
        rivals.push_back({pose, poseScore(fit, pose)});
    }
    std::stable_sort(rivals.begin(), rivals.end(),
                     [](const RivalPose& a, const RivalPose& b) { return a.score > b.score; });
    return rivals;
}

}  // namespace vestige
