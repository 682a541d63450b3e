#include "core/pipeline/TargetDistances.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

/// So many neighbours make a plane where their smallest spread is below this share of the middle one. Few
/// points seem flat by chance, so they must be flatter; many reach round the bends of a car body, so they
/// come last.
struct Flatness {
    std::size_t neighbours;
    double share;
};
constexpr std::array<Flatness, 5> kFlat{{{12, 0.05}, {24, 0.1}, {48, 0.15}, {96, 0.2}, {192, 0.25}}};
/// Searched at first; all of them only where these are not enough.
constexpr std::size_t kFew = 24;
constexpr std::size_t kFoot = 8;
constexpr std::size_t kSamples = 512;
constexpr std::size_t kGrain = 512;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// Round the target's origin, in its unit.
struct Plane {
    Eigen::Vector3d middle;
    Eigen::Vector3d normal;
    double reach2;  ///< square of how far from the middle the points lie around the foot
};

std::optional<Plane> planeThrough(const PointCloud& cloud, std::span<const Octree::Neighbour> found,
                                  double share) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& neighbour : found) middle += cloud.offsets()[neighbour.point].cast<double>();
    middle /= static_cast<double>(found.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& neighbour : found) {
        const Eigen::Vector3d d = cloud.offsets()[neighbour.point].cast<double>() - middle;
        spread += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Eigen::Vector3d values = solver.eigenvalues();
    if (!(values[0] < share * values[1])) return std::nullopt;
    return Plane{middle, solver.eigenvectors().col(0), 2 * values[2] / static_cast<double>(found.size() - 1)};
}

/// The target's surface at the place that is nearest to `offset`. Its points are looked for round that place,
/// not round `offset`: off the surface, noise would choose those that it brought nearer.
std::optional<Plane> surfaceAt(const Octree& target, const Eigen::Vector3d& offset,
                               std::vector<Octree::Neighbour>& found) {
    const PointCloud& cloud = target.cloud();
    target.nearest(offset.cast<float>(), kFoot, found);
    Eigen::Vector3f foot = Eigen::Vector3f::Zero();
    for (const auto& neighbour : found) foot += cloud.offsets()[neighbour.point];
    foot /= static_cast<float>(found.size());
    target.nearest(foot, kFew, found);
    for (const auto& [neighbours, share] : kFlat) {
        if (neighbours > kFew && found.size() == kFew) target.nearest(foot, kFlat.back().neighbours, found);
        if (found.size() < neighbours) break;
        if (const auto plane = planeThrough(cloud, std::span(found).first(neighbours), share)) return plane;
    }
    return std::nullopt;
}

double typicalSpacing(const Octree& target) {
    std::vector<float> spacings;
    for (const std::uint32_t sample : target.coarse(kSamples))
        spacings.push_back(target.localSpacing(sample));
    const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return *middle;
}

/// Source points by the cell of a grid that they lie in.
struct Cells {
    struct Member {
        std::array<std::int32_t, 3> cell;
        std::uint32_t point;
    };
    std::vector<Member> members;        ///< by cell, then point
    std::vector<std::uint32_t> begins;  ///< of each cell in `members`, and the end

    Cells(const PointCloud& source, const Similarity& targetFromSource, const Eigen::Vector3d& origin,
          double size) {
        members.resize(source.size());
        parallelFor(source.size(), 65536, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Eigen::Vector3d offset = (targetFromSource * source.point(i) - origin) / size;
                for (int axis = 0; axis < 3; ++axis)
                    members[i].cell[static_cast<std::size_t>(axis)] =
                        static_cast<std::int32_t>(std::floor(std::clamp(offset[axis], -2e9, 2e9)));
                members[i].point = static_cast<std::uint32_t>(i);
            }
        });
        std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.point < b.point;
        });
        for (std::size_t i = 0; i < members.size(); ++i)
            if (i == 0 || members[i].cell != members[i - 1].cell)
                begins.push_back(static_cast<std::uint32_t>(i));
        begins.push_back(static_cast<std::uint32_t>(members.size()));
    }
    std::size_t size() const { return begins.size() - 1; }
};

/// Of an even sample: a few points far off must not decide.
Eigen::Vector3d middleOf(const PointCloud& source, const Similarity& worldFromSource) {
    const std::size_t stride = std::max<std::size_t>(1, source.size() / 50000);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
    for (std::size_t i = 0; i < source.size(); i += stride, ++count) sum += worldFromSource * source.point(i);
    return sum / count;
}

/// Where the plane's positive side is, for a point there; all in the world.
Eigen::Vector3d outward(const Eigen::Vector3d& point, const Eigen::Vector3d& middle) {
    Eigen::Vector3d level = point - middle;
    level.z() = 0;
    if (const double length = level.norm(); length > 0) level /= length;
    return level + Eigen::Vector3d::UnitZ();
}

}  // namespace

std::vector<float> targetDistances(const Octree& target, const Similarity& worldFromTarget,
                                   const PointCloud& source, const Similarity& worldFromSource,
                                   const JobControl& control) {
    std::vector<float> distances(source.size(), kNothing);
    if (target.cloud().size() < kFlat.front().neighbours || source.empty()) return distances;
    const PointCloud& cloud = target.cloud();
    const Similarity targetFromSource = worldFromTarget.inverse() * worldFromSource;
    const Eigen::Matrix3d worldTurn = worldFromTarget.pose.linear();
    const Eigen::Vector3d middle = middleOf(source, worldFromSource);
    const double size = std::max(0.5 * typicalSpacing(target), 1e-9);
    const Cells cells(source, targetFromSource, cloud.origin(), size);
    const auto place = [&](const Cells::Member& member) -> Eigen::Vector3d {
        return targetFromSource * source.point(member.point) - cloud.origin();
    };
    // In parts, so that it can be cancelled and tells how far it is.
    const std::size_t part = std::max<std::size_t>(kGrain, cells.size() / 64);
    for (std::size_t first = 0; first < cells.size(); first += part) {
        if (control.cancelled()) return {};
        control.progress(static_cast<double>(first) / static_cast<double>(cells.size()));
        parallelFor(std::min(part, cells.size() - first), kGrain, [&](std::size_t begin, std::size_t end) {
            std::vector<Octree::Neighbour> found;
            for (std::size_t cell = first + begin; cell < first + end; ++cell) {
                const std::span members(cells.members.data() + cells.begins[cell],
                                        cells.members.data() + cells.begins[cell + 1]);
                const Eigen::Vector3d centre = place(members[members.size() / 2]);
                const auto plane = surfaceAt(target, centre, found);
                if (!plane) continue;
                const Eigen::Vector3d up = outward(worldFromTarget * (centre + cloud.origin()), middle);
                const double side = (worldTurn * plane->normal).dot(up) < 0 ? -1 : 1;
                for (const Cells::Member& member : members) {
                    const Eigen::Vector3d offset = place(member) - plane->middle;
                    const double along = offset.dot(plane->normal);
                    if (offset.squaredNorm() - along * along > plane->reach2) continue;
                    distances[member.point] = static_cast<float>(worldFromTarget.scale * side * along);
                }
            }
        });
    }
    control.progress(1);
    return distances;
}

}  // namespace vestige
