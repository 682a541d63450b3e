#include "core/registration/ndt/StartFan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>

#include "core/base/Parallel.h"
#include "core/registration/OverlapQuality.h"

namespace vestige {
namespace {

/// Right poses on streets explain 0.69 and 0.83, those that the first try lost at 5 m and 45 degrees up to
/// 0.34.
constexpr double kLeastExplained = 0.5;
constexpr double kNear = 1.0 / 16;  // of v0
constexpr std::size_t kFanPoints = 1024;
constexpr std::size_t kDescents = 24;
constexpr std::size_t kKept = 4;
constexpr double kShift = 0.625;  // of v0

struct Start {
    Pose pose = Pose::Identity();
    double score = 0;
};

/// Every k-th point, so that about `count` remain.
CentredSource sampled(const CentredSource& source, std::size_t count) {
    CentredSource few{{}, source.centre, source.radius};
    const std::size_t step = std::max<std::size_t>(1, source.points.size() / count);
    for (std::size_t i = 0; i < source.points.size(); i += step) few.points.push_back(source.points[i]);
    return few;
}

/// No turn, and two angles about the twelve corners of an icosahedron. cos and sin of half of 25 and 45
/// degrees.
std::vector<Eigen::Matrix3d> turns() {
    constexpr std::array kHalves{std::pair{0.97629600711993336, 0.21643961393810288},
                                 std::pair{0.92387953251128674, 0.38268343236508978}};
    std::vector<Eigen::Matrix3d> all{Eigen::Matrix3d::Identity()};
    for (const auto& [cosine, sine] : kHalves)
        for (int axis = 0; axis < 3; ++axis)
            for (const double first : {-1.0, 1.0})
                for (const double second : {-std::numbers::phi, std::numbers::phi}) {
                    Eigen::Vector3d corner;
                    corner[axis] = 0;
                    corner[(axis + 1) % 3] = first;
                    corner[(axis + 2) % 3] = second;
                    corner *= sine / corner.norm();
                    all.push_back(
                        Eigen::Quaterniond(cosine, corner.x(), corner.y(), corner.z()).toRotationMatrix());
                }
    return all;
}

std::vector<Start> fanAround(const Pose& start, double shift) {
    std::vector<Start> fan;
    for (const Eigen::Matrix3d& turn : turns())
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y)
                for (int z = -1; z <= 1; ++z) {
                    Pose pose = start;
                    pose.linear() = turn * start.linear();
                    pose.translation() += shift * Eigen::Vector3d(x, y, z);
                    fan.push_back({pose, 0});
                }
    return fan;
}

void keepBest(std::vector<Start>& starts, std::size_t count) {
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.score < b.score; });
    if (starts.size() > count) starts.resize(count);
}

}  // namespace

bool explainsTooLittle(const TargetLevels& levels, const CentredSource& source, const Pose& pose) {
    const auto near = static_cast<float>(kNear * levels.size(0));
    std::size_t explained = 0;
    const auto whole = levels.seen(levels.wholeLevels() - 1);
    for (const float distance : surfaceDistances(whole, source, pose))
        if (distance <= near) ++explained;
    return static_cast<double>(explained) < kLeastExplained * static_cast<double>(source.points.size());
}

std::vector<Pose> startFan(const TargetLevels& levels, const CentredSource& source, const Pose& start,
                           const TrustRegionOptions& limits) {
    const CentredSource few = sampled(source, kFanPoints);
    const NdtScore score(levels.seen(0), few);
    std::vector<Start> fan = fanAround(start, kShift * levels.size(0));
    parallelFor(fan.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) fan[i].score = score.value(fan[i].pose);
    });
    keepBest(fan, kDescents);
    parallelFor(fan.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const TrustRegionOutcome outcome =
                minimise([&](const Pose& pose) { return score(pose); }, fan[i].pose, few.radius, limits);
            fan[i] = {outcome.pose, outcome.scored.score};
        }
    });
    keepBest(fan, kKept);
    std::vector<Pose> poses;
    for (const Start& one : fan) poses.push_back(one.pose);
    return poses;
}

}  // namespace vestige
