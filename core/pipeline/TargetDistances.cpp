#include "core/pipeline/TargetDistances.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::array<std::size_t, 6> kNeighbourCounts{8, 16, 32, 64, 128, 256};
constexpr std::size_t kSamples = 512;
/// Of the samples that make a plane with the most neighbours: as many must with fewer.
constexpr double kShare = 0.8;
constexpr std::size_t kGrain = 512;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// Round the target's origin, in its unit.
struct Plane {
    Eigen::Vector3d middle;
    Eigen::Vector3d normal;
    double reach2;  ///< square of how far from the middle the points lie around the foot
};

std::optional<Plane> planeThrough(const PointCloud& cloud, const std::vector<Octree::Neighbour>& found) {
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
    if (!(values[0] < 0.1 * values[1])) return std::nullopt;
    return Plane{middle, solver.eigenvectors().col(0), 2 * values[2] / static_cast<double>(found.size() - 1)};
}

/// Round the place of the target that is nearest to `offset`: round `offset` itself, off the surface, noise
/// would choose the points that it brought nearer.
void neighboursOfFoot(const Octree& target, const Eigen::Vector3d& offset, std::size_t count,
                      std::vector<Octree::Neighbour>& found) {
    target.nearest(offset.cast<float>(), kNeighbourCounts.front(), found);
    Eigen::Vector3f foot = Eigen::Vector3f::Zero();
    for (const auto& neighbour : found) foot += target.cloud().offsets()[neighbour.point];
    target.nearest(foot / static_cast<float>(found.size()), count, found);
}

/// As few as make planes of the target's surfaces in spite of its noise.
std::size_t neighbourCount(const Octree& target) {
    const PointCloud& cloud = target.cloud();
    const std::vector<std::uint32_t> samples = target.coarse(kSamples);
    std::array<std::size_t, kNeighbourCounts.size()> flat{};
    std::vector<Octree::Neighbour> found;
    for (std::size_t k = 0; k < kNeighbourCounts.size(); ++k)
        for (const std::uint32_t sample : samples) {
            target.nearest(cloud.offsets()[sample], kNeighbourCounts[k], found);
            flat[k] += found.size() == kNeighbourCounts[k] && planeThrough(cloud, found);
        }
    const auto most = static_cast<double>(*std::max_element(flat.begin(), flat.end()));
    for (std::size_t k = 0; k < kNeighbourCounts.size(); ++k)
        if (static_cast<double>(flat[k]) >= kShare * most) return kNeighbourCounts[k];
    return kNeighbourCounts.back();
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
    if (target.cloud().size() < kNeighbourCounts.front() || source.empty()) return distances;
    const PointCloud& cloud = target.cloud();
    const Similarity targetFromSource = worldFromTarget.inverse() * worldFromSource;
    const Eigen::Matrix3d worldTurn = worldFromTarget.pose.linear();
    const Eigen::Vector3d middle = middleOf(source, worldFromSource);
    const std::size_t neighbours = neighbourCount(target);
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
                neighboursOfFoot(target, centre, neighbours, found);
                const auto plane = planeThrough(cloud, found);
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
