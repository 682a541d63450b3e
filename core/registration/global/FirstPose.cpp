#include "core/registration/global/FirstPose.h"

#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Parallel.h"
#include "core/base/UnitWords.h"
#include "core/base/Units.h"
#include "core/registration/FindPose.h"
#include "core/registration/InitialPose.h"
#include "core/registration/RegistrationFrame.h"
#include "core/registration/global/JudgePoses.h"
#include "core/registration/global/ProposePoses.h"
#include "core/registration/global/SearchVoxel.h"

namespace vestige {
namespace {

constexpr double kMeshSamples = 3e5;
constexpr std::size_t kProposed = 12;
/// Of a local scan, whose place may show little of it.
constexpr std::size_t kProposedOfLocal = 50;
constexpr std::size_t kShown = 8;
/// Below this no candidate is worth a registration.
constexpr double kLeastScore = 0.02;
/// A better score than this needs no second look with other voxels, unless it has rivals.
constexpr double kConvincing = 0.35;
constexpr double kOtherVoxel = 1.5;
constexpr std::size_t kOwnPoints = 200000;
/// A source smaller than this share of the target is a local scan: what surrounds its place must not pull it
/// away, so the registration is told how good the first pose is.
constexpr double kLocal = 0.25;
constexpr double kErrorPerVoxel = 0.25;

/// The cloud itself; points off a mesh, which `sampled` holds.
const PointCloud& pointsOf(const TriangleMesh& geometry, PointCloud& sampled) {
    if (!geometry.isMesh()) return geometry.vertices;
    sampled = sampleSurface(geometry, std::sqrt(surfaceArea(geometry) / kMeshSamples));
    return sampled;
}

struct Candidate {
    JudgedPose judged;
    Similarity targetFromSource;
    double voxel_m = 0;
    JudgeBy by = JudgeBy::cover;
};

/// What is found with one unit.
struct UnitSearch {
    std::vector<Candidate> candidates;  // best first
    double radius_m = 0;
    double voxel_m = 0;
    JudgeBy by = JudgeBy::cover;
};

/// At most `count` points of the cloud, spread over its order.
std::vector<Eigen::Vector3f> metresFrom(const Eigen::Vector3d& origin, const PointCloud& cloud, double scale,
                                        std::size_t count) {
    std::vector<Eigen::Vector3f> points(std::min(count, cloud.size()));
    parallelFor(points.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            points[i] = (scale * cloud.point(i * cloud.size() / points.size()) - origin).cast<float>();
    });
    return points;
}

UnitSearch searchWithUnit(const PointCloud& target, const PointCloud& source, double scale,
                          const ParameterSet& parameters, const JobControl& control) {
    UnitSearch search;
    search.radius_m = scale * surfaceRadius(source);
    if (search.radius_m < kLocal * surfaceRadius(target)) search.by = JudgeBy::shape;
    const bool local = search.by == JudgeBy::shape;
    const std::size_t count = local ? kProposedOfLocal : kProposed;
    search.voxel_m = parameters.optionalReal("search_voxel_m")
                         .value_or(searchVoxel(target, source, scale, search.radius_m));
    const double margin = parameters.real("search_margin");
    const Surfels here = surfelsOf(source, scale, search.voxel_m, control);
    const Surfels there = surfelsOf(target, 1, search.voxel_m, control);
    if (here.size() < kFewestSurfels || there.size() < kFewestSurfels) return search;
    const std::vector<Eigen::Vector3f> points = metresFrom(there.origin, target, 1, target.size());
    const std::vector<Eigen::Vector3f> own = metresFrom(here.origin, source, scale, kOwnPoints);
    std::vector<ProposedPose> proposals = proposePoses(there, here, count, control.sub(0, 0.4));
    std::vector<JudgedPose> judged = judgePoses(points, here, own, proposals, search.by);
    const bool convincing =
        !local && !judged.empty() && judged[0].score > kConvincing &&
        (judged.size() < 2 || !rivals(judged[1], judged[0], search.by, search.voxel_m, margin));
    if (!convincing) {
        const Surfels coarseHere = surfelsOf(source, scale, kOtherVoxel * search.voxel_m, control);
        const Surfels coarseThere = surfelsOf(target, 1, kOtherVoxel * search.voxel_m, control);
        for (ProposedPose pose : proposePoses(coarseThere, coarseHere, count, control.sub(0.5, 0.9))) {
            // From the coarse surfels' frames to the fine ones'.
            pose.targetFromSource.translation() +=
                coarseThere.origin - there.origin -
                pose.targetFromSource.linear() * (coarseHere.origin - here.origin);
            proposals.push_back(pose);
        }
        judged = judgePoses(points, here, own, proposals, search.by);
    }
    for (const JudgedPose& one : judged) {
        Similarity world{one.targetFromSource, scale};
        world.pose.translation() =
            there.origin + one.targetFromSource.translation() - one.targetFromSource.linear() * here.origin;
        search.candidates.push_back({one, world, search.voxel_m, search.by});
    }
    return search;
}

std::vector<double> scalesToTry(const TriangleMesh& target, const TriangleMesh& source,
                                std::optional<double> metresPerUnit, std::vector<std::string>& notes) {
    if (metresPerUnit) return {exactUnit(*metresPerUnit)};
    const UnitGuess guess = guessUnit(target, 1, source, {});
    if (guess.certain) {
        if (guess.metresPerUnit != 1) notes.push_back(guess.reason);
        return {guess.metresPerUnit};
    }
    std::vector<double> scales;
    const double extent = source.vertices.bounds().diagonal();
    const double scene = target.vertices.bounds().diagonal();
    const double millimetre = metresPer(LengthUnit::millimetre);
    for (const double one : {guess.metresPerUnit, guess.metresPerUnit == 1 ? millimetre : 1})
        if (plausibleExtent(one * extent, scene)) scales.push_back(one);
    if (scales.empty()) scales.push_back(guess.metresPerUnit);
    if (scales.size() > 1)
        notes.emplace_back("the unit is not certain, metres and millimetres were both tried");
    return scales;
}

std::string describe(const Candidate& candidate) {
    const Eigen::Vector3d at = candidate.targetFromSource.pose.translation();
    const Evidence& evidence = candidate.judged.evidence;
    const std::string mismatch = fixedText(1000 * std::sqrt(evidence.mostMismatch_m2()), 1);
    return "at " + fixedText(at.x(), 2) + ", " + fixedText(at.y(), 2) + ", " + fixedText(at.z(), 2) +
           " (score " + fixedText(candidate.judged.score, 2) +
           (candidate.by == JudgeBy::shape ? ", shapes differ by " + mismatch + " mm at most" : "") + ", " +
           fixedText(100 * evidence.coverage, 0) + " % of the scan met)";
}

/// What a registration makes of a candidate that the search alone cannot rule out.
struct Fit {
    double overlap = 0;
    double rmse_m = 0;
};

std::optional<Fit> fitFrom(const PointCloud& target, const PointCloud& source, const Candidate& candidate,
                           const FirstPose& first, ParameterSet parameters, const JobControl& control) {
    if (first.error_m && parameters.isDefault("start_error_m"))
        if (const Status set = parameters.set("start_error_m", *first.error_m); !set)
            throw ErrorException{set.error()};
    const auto result = findPose(target, source, candidate.targetFromSource, parameters, control);
    if (!result && result.error().code == ErrorCode::cancelled) throw ErrorException{result.error()};
    if (!result) return std::nullopt;
    return Fit{result->overlap, result->rmse_m};
}

/// A rival stays one when the scan, registered there, lies on as much of the target and as closely.
bool fitsAsWell(const std::optional<Fit>& rival, const std::optional<Fit>& best) {
    constexpr double kOverlap = 0.93;
    constexpr double kDistance = 1.25;
    if (!rival) return false;
    return !best || (rival->overlap >= kOverlap * best->overlap && rival->rmse_m <= kDistance * best->rmse_m);
}

}  // namespace

Result<FirstPose> findFirstPose(const TriangleMesh& target, const TriangleMesh& source,
                                std::optional<double> metresPerUnit, const ParameterSet& parameters,
                                const JobControl& control) {
    return guarded("search for a first pose", [&]() -> Result<FirstPose> {
        PointCloud offTarget;
        PointCloud offSource;
        const PointCloud& there = pointsOf(target, offTarget);
        const PointCloud& here = pointsOf(source, offSource);
        if (there.empty() || here.empty())
            return fail(ErrorCode::untrustworthy,
                        there.empty() ? "the target is empty" : "the source is empty");
        FirstPose first;
        std::vector<Candidate> candidates;
        const std::vector<double> scales = scalesToTry(target, source, metresPerUnit, first.notes);
        for (std::size_t i = 0; i < scales.size(); ++i) {
            const auto part = [&](std::size_t k) {
                return static_cast<double>(k) / static_cast<double>(scales.size());
            };
            UnitSearch search =
                searchWithUnit(there, here, scales[i], parameters, control.sub(part(i), part(i + 1)));
            if (search.candidates.empty()) continue;
            if (!candidates.empty() && candidates[0].judged.score >= search.candidates[0].judged.score)
                continue;
            candidates = std::move(search.candidates);
        }
        if (candidates.empty() || candidates[0].judged.score < kLeastScore)
            return fail(ErrorCode::untrustworthy, "no place in the target looks like the source", {},
                        "give picked pairs (.csv) or a pose as the first pose, or the unit");
        const Candidate& best = candidates.front();
        first.targetFromSource = best.targetFromSource;
        if (best.by == JudgeBy::shape) first.error_m = kErrorPerVoxel * best.voxel_m;
        const double margin = parameters.real("search_margin");
        first.notes.push_back("first pose found " + describe(best) + ", with voxels of " +
                              fixedText(best.voxel_m, 3) + " m, the source in " +
                              unitWords(best.targetFromSource.scale));
        std::optional<Fit> fitOfBest;
        for (std::size_t i = 0; i < std::min(kShown, candidates.size()); ++i) {
            const Candidate& one = candidates[i];
            if (i > 0 && one.judged.score <= 0) break;
            first.candidates.push_back({one.targetFromSource, std::clamp(one.judged.score, 0.0, 1.0)});
            if (i == 0) continue;
            bool rival = rivals(one.judged, best.judged, best.by, best.voxel_m, margin);
            if (rival && best.by == JudgeBy::cover) {
                if (!fitOfBest)
                    fitOfBest = fitFrom(there, here, best, first, parameters, control.sub(0.9, 1));
                rival =
                    fitsAsWell(fitFrom(there, here, one, first, parameters, control.sub(0.9, 1)), fitOfBest);
            }
            first.ambiguous = first.ambiguous || rival;
            first.notes.push_back(describe(one) + (rival ? ": as good" : ": worse"));
        }
        control.progress(1, "first pose");
        return first;
    });
}

void addFirstPose(RegistrationResult& result, const FirstPose& first) {
    result.notes.insert(result.notes.begin(), first.notes.begin(), first.notes.end());
    result.candidates = first.candidates;
    if (!first.ambiguous || result.verdict == Verdict::failed) return;
    result.verdict = Verdict::ambiguous;
    result.reasons.emplace(result.reasons.begin(),
                           "the scan fits several places equally well, the data cannot tell them apart");
}

}  // namespace vestige
