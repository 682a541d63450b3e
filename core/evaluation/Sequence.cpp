#include "core/evaluation/Sequence.h"

#include <algorithm>
#include <numeric>

#include "core/evaluation/SequenceFiles.h"
#include "core/evaluation/Trajectory.h"
#include "core/io/FormatRegistry.h"

namespace vestige {
namespace {

/// Index of each cloud's pose.
Result<std::vector<std::size_t>> posesOf(const SequenceFiles& files, const Trajectory& trajectory,
                                         const std::string& truth) {
    if (files.clouds.size() != trajectory.poses.size())
        return fail(ErrorCode::input,
                    "there are " + std::to_string(trajectory.poses.size()) + " poses for " +
                        std::to_string(files.clouds.size()) + " clouds",
                    truth, "expected one pose per cloud");
    std::vector<std::size_t> order(files.clouds.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (files.ids.empty() || trajectory.ids.empty()) return order;
    // Numbers that begin elsewhere (0 here, 1 there) mean the same order.
    std::vector<std::size_t> byId = order;
    std::sort(byId.begin(), byId.end(),
              [&](std::size_t a, std::size_t b) { return trajectory.ids[a] < trajectory.ids[b]; });
    const std::int64_t shift = trajectory.ids[byId[0]] - files.ids[0];
    for (std::size_t i = 0; i < order.size(); ++i)
        if (trajectory.ids[byId[i]] - files.ids[i] != shift)
            return fail(ErrorCode::input, "no poseId belongs to " + files.clouds[i].filename().string(),
                        truth, "expected a pose for the number of each cloud");
    return byId;
}

}  // namespace

Result<Sequence> readSequence(const std::filesystem::path& folder, const std::filesystem::path& truth,
                              SequenceFrame frame, const JobControl& control) {
    const Result<Trajectory> trajectory = readTrajectory(truth);
    if (!trajectory) return fail(trajectory.error());
    const Result<SequenceFiles> files = sequenceFiles(folder, truth);
    if (!files) return fail(files.error());
    const Result<std::vector<std::size_t>> order = posesOf(*files, *trajectory, truth.string());
    if (!order) return fail(order.error());
    const bool inWorldFrame =
        frame == SequenceFrame::byName ? files->inWorldFrame : frame == SequenceFrame::world;
    const double share = 1 / static_cast<double>(files->clouds.size());
    Sequence sequence;
    for (std::size_t i = 0; i < files->clouds.size(); ++i) {
        const auto done = static_cast<double>(i);
        Result<LoadedGeometry> loaded =
            readGeometry(files->clouds[i], control.sub(done * share, (done + 1) * share));
        if (!loaded) return fail(loaded.error());
        sequence.truth.push_back(trajectory->poses[(*order)[i]]);
        PointCloud cloud = std::move(loaded->geometry.vertices);
        if (inWorldFrame) cloud = cloud.transformed({sequence.truth[i].inverse(), 1});
        sequence.clouds.push_back(std::move(cloud));
    }
    return sequence;
}

SequenceExtent extentOf(const Sequence& sequence) {
    SequenceExtent extent;
    extent.clouds = sequence.clouds.size();
    for (const PointCloud& cloud : sequence.clouds) extent.points += cloud.size();
    for (std::size_t i = 1; i < sequence.truth.size(); ++i) {
        const Pose step = sequence.truth[i - 1].inverse() * sequence.truth[i];
        extent.path_m += step.translation().norm();
        extent.longestStep_m = std::max(extent.longestStep_m, step.translation().norm());
        extent.largestTurn_rad = std::max(extent.largestTurn_rad, rotationAngle(step.linear()));
    }
    return extent;
}

}  // namespace vestige
