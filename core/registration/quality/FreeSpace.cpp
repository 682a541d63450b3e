#include "core/registration/quality/FreeSpace.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr double kMarginOfRange = 0.01;  // half a degree of turn
constexpr double kBeyond = 5;            // tolerances
constexpr double kOwnThrough = 0.02;     // share of its own surface that a cloud may seem to see through
constexpr std::size_t kFewestCells = 50;
constexpr int kFewestRays = 5;
constexpr double kThrough = 0.9;  // of the rays that meet a piece
constexpr double kSeen = 0.5;
constexpr double kHoles = 0.05;  // a piece that more of its own scanner's rays go through is no surface

enum class Sight { seen, through, hidden };

Sight sightOf(const RayCounts& rays) {
    if (rays.all() < kFewestRays) return Sight::hidden;
    if (rays.behind >= kThrough * rays.all()) return Sight::through;
    return rays.on >= kSeen * rays.all() ? Sight::seen : Sight::hidden;
}

std::vector<RayCounts> raysThrough(const RangeImage& image, std::span<const SurfaceCell> cells,
                                   const Pose& pose, double margin_m) {
    std::vector<RayCounts> rays(cells.size());
    parallelFor(cells.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            SurfaceCell cell = cells[i];
            cell.mean = pose * cell.mean;
            cell.normal = pose.linear() * cell.normal;
            cell.wide = pose.linear() * cell.wide;
            const double range = (cell.mean - image.viewpoint()).norm();
            rays[i] = image.meeting(cell, margin_m + kMarginOfRange * range);
        }
    });
    return rays;
}

SightShares sharesOf(std::span<const SurfaceCell> cells, std::span<const RayCounts> rays) {
    SightShares shares;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Sight sight = sightOf(rays[i]);
        if (sight == Sight::hidden) continue;
        ++shares.cells;
        (sight == Sight::seen ? shares.seen_m2 : shares.through_m2) += cells[i].area_m2;
    }
    return shares;
}

/// Whether the cells' points lie rather evenly over the directions from a viewpoint, as a scanner's do, than
/// over the surface, as those of a cloud do that was fused or thinned.
bool evenOverDirections(std::span<const SurfaceCell> cells, const Eigen::Vector3d& viewpoint) {
    constexpr double kAskew = 0.15;
    std::vector<double> byDirection, bySurface;
    for (const SurfaceCell& cell : cells) {
        const Eigen::Vector3d ray = cell.mean - viewpoint;
        const double range = ray.norm();
        const double cosine = std::abs(cell.normal.dot(ray)) / range;
        if (!(cosine > kAskew)) continue;
        bySurface.push_back(cell.count / (cell.wide_m * cell.narrow_m));
        byDirection.push_back(bySurface.back() * range * range / cosine);
    }
    const auto spread = [](std::vector<double>& values) {
        if (values.empty()) return 1.0;
        std::sort(values.begin(), values.end());
        return values[values.size() * 3 / 4] / values[values.size() / 4];
    };
    return spread(byDirection) < spread(bySurface);
}

bool within(std::span<const Eigen::Vector3f> points, const Eigen::Vector3d& place) {
    if (points.empty()) return false;
    Eigen::Vector3f low = points.front(), high = points.front();
    for (const Eigen::Vector3f& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const Eigen::Vector3f eye = place.cast<float>();
    return (eye.array() >= low.array()).all() && (eye.array() <= high.array()).all();
}

}  // namespace

FreeSpace::FreeSpace(const Sighted& target, const Sighted& source, double tolerance_m, double largest_m)
    : tolerance_m_(tolerance_m),
      largest_m_(largest_m),
      margin_m_(kBeyond * tolerance_m),
      target_(sideOf(target)),
      source_(sideOf(source)) {}

FreeSpace::Side FreeSpace::sideOf(const Sighted& cloud) const {
    Side side;
    for (const SurfaceCell& cell : cloud.cells)
        if (cell.thickness_m <= tolerance_m_ && cell.size_m <= largest_m_) side.cells.push_back(cell);
    if (!within(cloud.points, cloud.viewpoint)) return side;
    RangeImage image(cloud.points, cloud.viewpoint);
    const auto rays = raysThrough(image, side.cells, Pose::Identity(), margin_m_);
    const SightShares own = sharesOf(side.cells, rays);
    if (own.cells < kFewestCells || own.through() > kOwnThrough ||
        !evenOverDirections(side.cells, cloud.viewpoint))
        return side;
    side.image = std::move(image);
    std::vector<SurfaceCell> whole;
    for (std::size_t i = 0; i < side.cells.size(); ++i)
        if (rays[i].behind <= kHoles * rays[i].all()) whole.push_back(side.cells[i]);
    side.cells = std::move(whole);
    return side;
}

std::optional<SightShares> FreeSpace::fromTarget(const Pose& pose) const {
    if (!target_.image) return std::nullopt;
    return sharesOf(source_.cells, raysThrough(*target_.image, source_.cells, pose, margin_m_));
}

std::optional<SightShares> FreeSpace::fromSource(const Pose& pose) const {
    if (!source_.image) return std::nullopt;
    const Pose back = pose.inverse();
    return sharesOf(target_.cells, raysThrough(*source_.image, target_.cells, back, margin_m_));
}

double FreeSpace::through(const Pose& pose) const {
    const auto one = fromTarget(pose);
    const auto two = fromSource(pose);
    return std::max(one ? one->through() : 0, two ? two->through() : 0);
}

}  // namespace vestige
