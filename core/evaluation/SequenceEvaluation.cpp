#include "core/evaluation/SequenceEvaluation.h"

#include <chrono>

#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/evaluation/SequenceFiles.h"
#include "core/evaluation/Trajectory.h"
#include "core/filters/Preprocess.h"
#include "core/io/FormatRegistry.h"
#include "core/registration/Register.h"

namespace vestige {
namespace {

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

Result<Sequence> readSequence(const std::filesystem::path& folder, const std::filesystem::path& truth,
                              const JobControl& control) {
    Result<std::vector<Pose>> poses = readTrajectory(truth);
    if (!poses) return fail(poses.error());
    const Result<SequenceFiles> files = sequenceFiles(folder, truth);
    if (!files) return fail(files.error());
    if (files->clouds.size() != poses->size())
        return fail(ErrorCode::input,
                    "there are " + std::to_string(poses->size()) + " poses for " +
                        std::to_string(files->clouds.size()) + " clouds",
                    truth.string(), "expected one pose per cloud, in the order of the clouds' names");
    Sequence sequence;
    sequence.truth = std::move(*poses);
    for (std::size_t i = 0; i < files->clouds.size(); ++i) {
        Result<LoadedGeometry> loaded = readGeometry(files->clouds[i], control);
        if (!loaded) return fail(loaded.error());
        PointCloud cloud = std::move(loaded->geometry.vertices);
        if (files->inWorldFrame) cloud = cloud.transformed({sequence.truth[i].inverse(), 1});
        sequence.clouds.push_back(std::move(cloud));
    }
    return sequence;
}

Result<SequenceScore> evaluateSequence(const Sequence& sequence, const ParameterSet& preprocessing,
                                       const ParameterSet& registration, const JobControl& control) {
    SequenceScore score;
    score.method = registration.text("method");
    const auto voxel = registration.optionalReal("voxel_m");
    score.voxel = voxel ? exactText(*voxel) : "auto";
    score.filter = preprocessing.text("filter");
    std::vector<Pose> estimates{Pose::Identity()};
    TriangleMesh before;
    for (std::size_t i = 0; i < sequence.clouds.size(); ++i) {
        const auto filtering = std::chrono::steady_clock::now();
        Result<PointCloud> filtered = preprocess(sequence.clouds[i], preprocessing);
        if (!filtered) return fail(filtered.error());
        TriangleMesh cloud{std::move(*filtered), {}};
        score.preprocessSeconds += secondsSince(filtering);
        if (i > 0) {
            const auto registering = std::chrono::steady_clock::now();
            const Result<RegistrationResult> result = registerGeometry(before, cloud, {}, registration);
            score.seconds += secondsSince(registering);
            if (!result && result.error().code != ErrorCode::untrustworthy) return fail(result.error());
            if (!result) ++score.failed;
            estimates.push_back(estimates.back() *
                                (result ? result->targetFromSource.pose : Pose::Identity()));
        }
        before = std::move(cloud);
        if (control.cancelled()) return fail(cancelledError());
        control.progress(static_cast<double>(i + 1) / static_cast<double>(sequence.clouds.size()),
                         score.method);
    }
    const Result<RelativePoseError> error = relativePoseError(estimates, sequence.truth);
    if (!error) return fail(error.error());
    score.error = *error;
    return score;
}

std::string sequenceCsv(const std::vector<SequenceScore>& scores) {
    std::string text = csvLine({"method", "voxel_m", "filter", "pairs", "failed", "rpe_m", "rpe_deg",
                                "seconds", "preprocess_seconds"});
    for (const SequenceScore& score : scores)
        text += csvLine({score.method, score.voxel == "auto" ? "" : score.voxel, score.filter,
                         std::to_string(score.error.pairs), std::to_string(score.failed),
                         exactText(score.error.translation_m), exactText(degrees(score.error.rotation_rad)),
                         exactText(score.seconds), exactText(score.preprocessSeconds)});
    return text;
}

}  // namespace vestige
