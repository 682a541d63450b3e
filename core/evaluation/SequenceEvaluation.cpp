#include "core/evaluation/SequenceEvaluation.h"

#include <chrono>

#include "core/filters/Preprocess.h"
#include "core/registration/Register.h"

namespace vestige {
namespace {

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The pose of `cloud` in the frame of `before`; `pair` gets the rest.
Result<Pose> registerPair(const TriangleMesh& before, const TriangleMesh& cloud,
                          const ParameterSet& parameters, PairScore& pair, const JobControl& control) {
    const auto begin = std::chrono::steady_clock::now();
    const Result<RegistrationResult> result = attemptRegistration(before, cloud, {}, parameters, control);
    pair.seconds = secondsSince(begin);
    if (!result && result.error().code != ErrorCode::untrustworthy) return fail(result.error());
    if (!result) return Pose::Identity();
    pair.seconds = result->seconds;
    pair.verdict = result->verdict;
    pair.overlap = result->overlap;
    return result->targetFromSource.pose;
}

PairScore pairAt(const Sequence& sequence, std::size_t from) {
    PairScore pair;
    pair.from = from;
    const Pose moved = sequence.truth[from].inverse() * sequence.truth[from + 1];
    pair.moved = {moved.translation().norm(), rotationAngle(moved.linear())};
    return pair;
}

}  // namespace

Result<SequenceScore> evaluateSequence(const Sequence& sequence, const ParameterSet& preprocessing,
                                       const ParameterSet& registration, std::size_t distance,
                                       const JobControl& control) {
    SequenceScore score;
    score.method = registration.text("method");
    score.voxel_m = registration.optionalReal("voxel_m");
    score.filter = preprocessing.text("filter");
    score.distance = distance;
    std::vector<Pose> estimates{Pose::Identity()};
    TriangleMesh before;
    const double share = 1 / static_cast<double>(sequence.clouds.size());
    for (std::size_t i = 0; i < sequence.clouds.size(); ++i) {
        const JobControl one =
            control.sub(static_cast<double>(i) * share, static_cast<double>(i + 1) * share);
        const auto filtering = std::chrono::steady_clock::now();
        Result<PointCloud> filtered = preprocess(sequence.clouds[i], preprocessing, 1, one.sub(0, 0.3));
        if (!filtered) return fail(filtered.error());
        TriangleMesh cloud{std::move(*filtered), {}};
        score.preprocessSeconds += secondsSince(filtering);
        if (i > 0) {
            PairScore pair = pairAt(sequence, i - 1);
            const Result<Pose> step = registerPair(before, cloud, registration, pair, one.sub(0.3, 1));
            if (!step) return fail(step.error());
            score.seconds += pair.seconds;
            if (pair.verdict == Verdict::failed || pair.verdict == Verdict::ambiguous) ++score.failed;
            estimates.push_back(estimates.back() * *step);
            score.pairs.push_back(pair);
        }
        before = std::move(cloud);
        if (control.cancelled()) return fail(cancelledError());
        one.progress(1, score.method);
    }
    const Result<RelativePoseError> neighbours = relativePoseError(estimates, sequence.truth);
    if (!neighbours) return fail(neighbours.error());
    for (std::size_t i = 0; i < score.pairs.size(); ++i) score.pairs[i].error = neighbours->each[i];
    Result<RelativePoseError> error = relativePoseError(estimates, sequence.truth, distance);
    if (!error) return fail(error.error());
    score.error = std::move(*error);
    return score;
}

}  // namespace vestige
