#include "core/registration/ndt/NdtScore.h"

#include <algorithm>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr std::size_t kGroup = 8;

}  // namespace

NdtScore::NdtScore(std::span<const NormalDistributions> target, const CentredSource& source,
                   std::span<const NormalDistributions> shifted)
    : source_(source.points), radius_(source.radius) {
    Levels levels;
    for (std::size_t level = target.size(); level-- > 0;) levels.push_back(&target[level]);
    grids_.push_back(levels);
    for (const NormalDistributions& grid : shifted) {
        levels.front() = &grid;
        grids_.push_back(levels);
    }
}

ScoredPose NdtScore::operator()(const Pose& pose, Memory* memory) const {
    ScoredPose scored;
    const double share = 1 / static_cast<double>(source_.count * grids_.size());
    const std::size_t chunks = (source_.count + kGrain - 1) / kGrain;
    std::vector<NdtSums> parts(chunks * grids_.size());
    const std::size_t groups = source_.x.size() / kGroup;
    if (memory != nullptr && memory->empty()) memory->resize(groups * grids_.size());
    // A chunk of a grid is a task of its own, so that the last level feeds many threads.
    parallelFor(parts.size(), 1, [&](std::size_t from, std::size_t to) {
        for (std::size_t task = from; task < to; ++task) {
            const std::size_t begin = task % chunks * kGrain;
            const Levels& levels = grids_[task / chunks];
            const bool remembers = memory != nullptr && canRemember(levels);
            parts[task] =
                sumNdt(levels, source_, begin, std::min(begin + kGrain, source_.count), pose, radius_,
                       remembers ? std::span(*memory).subspan(task / chunks * groups, groups)
                                 : std::span<FoundCells>());
        }
    });
    NdtSums total;
    for (std::size_t grid = 0; grid < grids_.size(); ++grid) {
        NdtSums sums;
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) sums += parts[grid * chunks + chunk];
        scored.inside = std::max(scored.inside, sums.inside);
        total += sums;
    }
    scored.score = total.score * share;
    std::size_t entry = 0;
    for (int i = 0; i < 6; ++i) {
        scored.gradient[i] = total.gradient[static_cast<std::size_t>(i)] * share;
        for (int j = i; j < 6; ++j, ++entry)
            scored.hessian(i, j) = scored.hessian(j, i) = total.hessian[entry] * share;
    }
    return scored;
}

double NdtScore::value(const Pose& pose) const {
    double total = 0;
    for (const Levels& levels : grids_)
        total += parallelSum(source_.count, kGrain, 0.0, [&](std::size_t begin, std::size_t end) {
            return sumNdtScore(levels, source_, begin, end, pose);
        });
    return total / static_cast<double>(source_.count * grids_.size());
}

Pose NdtScore::moved(const Pose& pose, const Vector6d& step, double radius) {
    // The quaternion (1, w/2) turns by |w| up to third order and needs no sine that differs between machines.
    const Eigen::Vector3d half = step.tail<3>() / (2 * radius);
    Pose result = pose;
    result.translation() += step.head<3>();
    result.linear() =
        Eigen::Quaterniond(1, half.x(), half.y(), half.z()).normalized().toRotationMatrix() * pose.linear();
    return result;
}

}  // namespace vestige
