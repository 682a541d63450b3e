#include "core/registration/DenserSource.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/registration/FindPose.h"
#include "core/registration/Grain.h"
#include "core/registration/RegistrationFrame.h"

namespace vestige {
namespace {

constexpr double kTimesFiner = 4;
constexpr double kMarginOfRadius = 0.3;  // round the source's bounds
constexpr double kGrainCells = 4;        // to the source's radius
/// v_n, in spacings of the target's points, in thicknesses of its flattest surfaces, and as shares of the
/// source's radius.
constexpr double kSpacings = 1.25;
constexpr double kThicknesses = 2;
constexpr double kSmallest = 1.0 / 20;
constexpr double kLargest = 1.0 / 8;
constexpr double kStartPerCell = 4;  // v0 reaches 2 sigma of the first pose to either side
constexpr double kLevels = 4;        // v0 is at least as many v_n
constexpr std::size_t kModelPoints = 300000;
constexpr std::size_t kMovedPoints = 100000;
constexpr std::size_t kFewestPoints = 100;

/// The target's points within `margin` (target units) of the placed source's bounds.
PointCloud pointsRound(const PointCloud& target, const PointCloud& source, const Similarity& placed,
                       double margin) {
    BoundingBox box;
    for (std::size_t i = 0; i < source.size(); ++i) box.add(placed * source.point(i));
    std::vector<std::uint32_t> inside;
    for (std::uint32_t i = 0; i < target.size(); ++i) {
        const Eigen::Vector3d point = target.point(i);
        if (((point - box.min).array() > -margin).all() && ((box.max - point).array() > -margin).all())
            inside.push_back(i);
    }
    return target.select(inside);
}

PointCloud everySo(const PointCloud& cloud, std::size_t count) {
    if (cloud.size() <= count) return cloud;
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k < count; ++k)
        kept.push_back(static_cast<std::uint32_t>(k * cloud.size() / count));
    return cloud.select(kept);
}

bool applies(const ParameterSet& parameters) {
    return parameters.text("method") == "improved-ndt" && parameters.text("preset") == "default" &&
           parameters.optionalReal("start_error_m") && parameters.isDefault("voxel_start_m") &&
           parameters.isDefault("voxel_m") && parameters.isDefault("leaf_m");
}

void turnRound(RegistrationResult& result, const Similarity& initial) {
    const auto turned = [&](const Pose& sourceFromTarget) { return sourceFromTarget.inverse(); };
    result.targetFromSource = {turned(result.targetFromSource.pose), initial.scale};
    for (RegistrationLevel& level : result.levels) level.targetFromSource = turned(level.targetFromSource);
    std::swap(result.overlap, result.targetOverlap);
    result.initial = initial;
}

}  // namespace

std::optional<Result<RegistrationResult>> findPoseOnDenserSource(
    const PointCloud& target, const PointCloud& source, const Similarity& initial,
    const ParameterSet& parameters, const JobControl& control, const RegistrationWatch& watch) {
    if (!applies(parameters)) return std::nullopt;
    const PointCloud model = everySo(source, kModelPoints);
    const double radius_m = initial.scale * surfaceRadius(model);
    const PointCloud round = pointsRound(target, model, initial, kMarginOfRadius * radius_m);
    if (round.size() < kFewestPoints) return std::nullopt;
    const Grain there = grainOf(round, 1, radius_m / kGrainCells);
    const double spacing_m =
        grainOf(model, initial.scale, radius_m / kGrainCells).spacing_m *
        std::sqrt(static_cast<double>(model.size()) / static_cast<double>(source.size()));
    if (!(kTimesFiner * spacing_m < there.spacing_m)) return std::nullopt;
    const PointCloud near = everySo(round, kMovedPoints);

    ParameterSet swapped = parameters;
    const double voxel_m = std::clamp(std::max(kSpacings * there.spacing_m, kThicknesses * there.thickness_m),
                                      kSmallest * radius_m, kLargest * radius_m);
    const double voxelStart_m =
        std::max(kLevels * voxel_m, kStartPerCell * *parameters.optionalReal("start_error_m"));
    if (!swapped.set("voxel_m", voxel_m) || !swapped.set("voxel_start_m", voxelStart_m)) return std::nullopt;
    RegistrationWatch turnedWatch;
    if (watch)
        turnedWatch = [&](const RegistrationStep& step) {
            RegistrationStep turned = step;
            turned.targetFromSource = {step.targetFromSource.pose.inverse(), initial.scale};
            watch(turned);
        };
    auto result = findPose(model.transformed({Pose::Identity(), initial.scale}), near,
                           {initial.pose.inverse(), 1}, swapped, control, turnedWatch);
    if (!result) {
        if (result.error().code == ErrorCode::cancelled) return result;
        return std::nullopt;
    }
    turnRound(*result, initial);
    result->radius_m = radius_m;
    return result;
}

}  // namespace vestige
