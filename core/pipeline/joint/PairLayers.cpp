#include "core/pipeline/joint/PairLayers.h"

#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/pipeline/joint/ExpectedOverlap.h"
#include "core/scene/LayerUnit.h"

namespace vestige {
namespace {

/// Beyond the error of a place that a registration found: what the other scan needs to be seen from it.
constexpr double kPairReach_m = 0.5;

Similarity placed(const Similarity& to, const Similarity& toFromFrom) {
    return {to.pose * toFromFrom.pose, toFromFrom.scale};
}

/// How far off a first pose is where nothing else tells: between two scans, and between strips that their
/// navigation has placed.
constexpr double kUsualError_m = 0.05;
constexpr double kStripError_m = 0.25;

/// Registers from a first pose whose error bounds the first cell but, unlike that of picked pairs in a cloud
/// taken from the air, not the last one; no fit may go far from it.
Result<RegistrationResult> registerNear(const SceneState& scene, const Layer& source,
                                        PreparedRegistration prepared, double error_m, double leastCell_m,
                                        const JobControl& control, const RegistrationWatch& watch) {
    constexpr double kErrorsPerCell = 4;
    constexpr double kMovesAllowed = 10;
    constexpr double kMovesOfExtent = 0.05;
    prepared.voxelStart_m = std::max(kErrorsPerCell * error_m, leastCell_m);
    prepared.error_m.reset();
    auto result = attemptPair(scene, source, prepared, control, watch);
    if (!result || !result->trustworthy()) return result;
    const double extent_m = prepared.initial.scale * source.data->points->bounds().diagonal();
    const Eigen::Vector3d centre = source.data->points->bounds().centre();
    const Pose turn = result->targetFromSource.pose * prepared.initial.pose.inverse();
    const double moved_m = (result->targetFromSource * centre - prepared.initial * centre).norm() +
                           rotationAngle(turn.linear()) * extent_m / 4;
    if (moved_m > std::max(kMovesAllowed * error_m, kMovesOfExtent * extent_m)) {
        result->verdict = Verdict::failed;
        result->reasons = {"the fit moved the scan " + fixedText(moved_m, 2) +
                           " m from a first pose that is known much better than that"};
    }
    return result;
}

/// `watch` is told poses of the source in the frame of the target.
Result<RegistrationResult> registerTo(const SceneState& scene, const Layer& target, const Layer& source,
                                      PreparedRegistration prepared, const JobControl& control,
                                      const RegistrationWatch& watch) {
    const bool air = target.role == LayerRole::aerial;
    if (air && source.role == LayerRole::aerial && std::holds_alternative<InitIdentity>(source.init))
        return registerNear(scene, source, std::move(prepared), kStripError_m, 0, control, watch);
    if (air || target.id == scene.target) return attemptPair(scene, source, prepared, control, watch);
    // Two scans: neither shows much of what the other does, so large cells would pull them over each other.
    constexpr double kCellsPerExtent = 20;
    const double extent_m = prepared.initial.scale * source.data->points->bounds().diagonal();
    const double error_m = prepared.error_m.value_or(kUsualError_m);
    return registerNear(scene, source, std::move(prepared), error_m, extent_m / kCellsPerExtent, control,
                        watch);
}

class Pairing {
  public:
    Pairing(const SceneState& scene, PreparedLayers prepared, const LayerWatches& watches)
        : scene_(scene), prepared_(std::move(prepared)), watches_(watches) {}

    Status gather(const std::vector<std::string>& ids);
    Status place(const JobControl& control);
    Status pairUp(const JobControl& control);
    PairedLayers take() { return std::move(found_); }

  private:
    struct Candidate {
        std::size_t a;
        std::size_t b;
        double overlap;
    };

    Status placeFromFirstPoses(const JobControl& control, bool& progress);
    Status placeThroughOthers(const JobControl& control, bool& progress);
    Result<bool> registerFirst(std::size_t member, std::size_t reference, const JobControl& control);
    Result<bool> registerAgain(const Candidate& candidate, const JobControl& control);
    Result<MemberPair> registerFromPlaces(std::size_t to, std::size_t from, std::optional<double> error_m,
                                          const JobControl& control) const;
    RegistrationWatch watchOf(const Member& source, const Member& target) const;
    void enter(MemberPair pair);
    std::vector<Candidate> candidates(bool forUnsettled);
    double overlap(std::size_t a, std::size_t b) const;
    std::size_t indexOf(const std::string& id) const;
    /// Whether the two are paired, or were tried and nothing has changed since.
    bool isDone(std::size_t a, std::size_t b) const;
    JobControl next(const JobControl& control);

    const SceneState& scene_;
    PreparedLayers prepared_;
    const LayerWatches& watches_;
    PairedLayers found_;
    std::vector<std::size_t> pending_;  // not tried from their first poses yet
    std::vector<std::pair<std::size_t, std::size_t>> tried_;
    std::size_t steps_ = 0;
};

Status Pairing::gather(const std::vector<std::string>& ids) {
    if (!scene_.layer(scene_.target))
        return fail(ErrorCode::input, "the case names no layer that the others are registered to",
                    "registration.target", "one of the layers' ids");
    const auto asked = [&](const std::string& id) {
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    for (const std::string& id : ids)
        if (!scene_.layer(id))
            return fail(ErrorCode::input, "the case has no layer of this name", "layer " + id);
    if (asked(scene_.target))
        return fail(ErrorCode::usage, "the target cannot be registered to itself", "layer " + scene_.target);
    for (const Layer& layer : scene_.layers) {
        const bool given = layer.id == scene_.target || (layer.registration && layer.data);
        if (!asked(layer.id) && !given) continue;
        if (!layer.data || layer.data->points->empty())
            return fail(ErrorCode::input, "the layer has no points", "layer " + layer.id);
        Member member{layer, !asked(layer.id), {}, false, {}, {}, {}};
        if (member.fixed) {
            member.place = sceneFromLayer(layer);
            member.settled = true;
            if (layer.registration) member.error_m = layer.registration->rmse_m;
        } else {
            pending_.push_back(found_.members.size());
        }
        found_.members.push_back(std::move(member));
    }
    // Every first pose must lead to the target in the end.
    for (const std::size_t start : pending_) {
        std::size_t at = start;
        for (std::size_t steps = 0; !found_.members[at].fixed; ++steps) {
            const Layer& layer = found_.members[at].layer;
            const std::string to = referenceOf(layer.init);
            if (to.empty()) break;
            at = indexOf(to);
            if (at == found_.members.size())
                return fail(ErrorCode::input,
                            "its first pose leads to \"" + to + "\", which has no place in the scene",
                            "layer " + layer.id, "register that layer, too");
            if (steps > found_.members.size())
                return fail(ErrorCode::input, "the first poses lead from layer to layer in a circle",
                            "layer " + layer.id, "one of them must lead to the target");
        }
    }
    return {};
}

std::size_t Pairing::indexOf(const std::string& id) const {
    const auto found = std::find_if(found_.members.begin(), found_.members.end(),
                                    [&](const Member& member) { return member.layer.id == id; });
    return static_cast<std::size_t>(found - found_.members.begin());
}

/// Half of what is left for each step, of which nobody knows the number.
JobControl Pairing::next(const JobControl& control) {
    const double from = 1 - std::pow(0.8, static_cast<double>(steps_));
    const double to = 1 - std::pow(0.8, static_cast<double>(++steps_));
    return control.sub(from, to);
}

bool Pairing::isDone(std::size_t a, std::size_t b) const {
    const auto same = [&](std::size_t x, std::size_t y) { return std::minmax(x, y) == std::minmax(a, b); };
    for (const MemberPair& pair : found_.pairs)
        if (pair.result && same(pair.to, pair.from)) return true;
    return std::any_of(tried_.begin(), tried_.end(),
                       [&](const auto& pair) { return same(pair.first, pair.second); });
}

/// A pair that failed before is replaced.
void Pairing::enter(MemberPair pair) {
    const auto before = std::find_if(found_.pairs.begin(), found_.pairs.end(), [&](const MemberPair& other) {
        return std::minmax(other.to, other.from) == std::minmax(pair.to, pair.from);
    });
    if (before == found_.pairs.end())
        found_.pairs.push_back(std::move(pair));
    else
        *before = std::move(pair);
}

Result<bool> Pairing::registerFirst(std::size_t index, std::size_t reference, const JobControl& control) {
    Member& member = found_.members[index];
    const Member& to = found_.members[reference];
    const auto failed = [&](const Error& error) -> Result<bool> {
        if (error.code == ErrorCode::cancelled) return fail(error);
        if (!member.failure) member.failure = error;
        MemberPair pair{reference, index, {}, error.message};
        enter(std::move(pair));
        return false;
    };
    const auto known = prepared_.find(member.layer.id);
    const bool isPrepared = known != prepared_.end() && to.layer.id == scene_.target;
    Result<PreparedRegistration> prepared =
        isPrepared ? std::move(known->second) : fail(ErrorCode::input, "not prepared");
    if (isPrepared) prepared_.erase(known);
    const bool searched = std::holds_alternative<InitAuto>(member.layer.init);
    const auto start = [&](const Similarity& toFromMember, std::optional<double> error_m) {
        noteUnit(member.layer, toFromMember.scale);
        member.place = placed(*to.place, toFromMember);
        member.error_m = error_m;
    };
    if (!isPrepared || (!prepared && !searched)) {
        const auto placement = initialPlacement(scene_, member.layer, to.layer, control.sub(0, 0.2));
        if (!placement) return failed(placement.error());
        if (!isPrepared)
            prepared = preparePair(scene_, to.layer, member.layer, *placement, control.sub(0.2, 0.3));
        // Where it fails here, another layer may lie there.
        if (!prepared && !searched) start(placement->targetFromSource, placement->error_m);
    }
    if (!prepared) return failed(prepared.error());
    start(prepared->initial, prepared->error_m);
    auto result = registerTo(scene_, to.layer, member.layer, std::move(*prepared), control.sub(0.3, 1),
                             watchOf(member, to));
    if (!result) return failed(result.error());
    if (!result->trustworthy()) {
        const Error error = unreliable(*result, member.layer.id);
        if (to.layer.id != scene_.target) {
            result->targetFromSource = placed(*to.place, result->targetFromSource);
            result->initial = placed(*to.place, result->initial);
        }
        // A place that is one of several is none to start from again.
        if (result->verdict == Verdict::ambiguous) member.place.reset();
        if (!member.attempt) member.attempt = std::move(*result);
        return failed(error);
    }
    member.place = placed(*to.place, result->targetFromSource);
    member.error_m = result->rmse_m;
    member.settled = true;
    enter({reference, index, std::move(*result), {}});
    return true;
}

Status Pairing::placeFromFirstPoses(const JobControl& control, bool& progress) {
    for (std::size_t i = 0; i < pending_.size();) {
        const std::string to = referenceOf(found_.members[pending_[i]].layer.init);
        const std::size_t reference = indexOf(to.empty() ? scene_.target : to);
        if (!found_.members[reference].place) {
            ++i;
            continue;
        }
        const auto done = registerFirst(pending_[i], reference, next(control));
        if (!done) return fail(done.error());
        pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
        progress = true;
        i = 0;  // others may lead to it
    }
    return {};
}

double Pairing::overlap(std::size_t a, std::size_t b) const {
    const Member& first = found_.members[a];
    const Member& second = found_.members[b];
    return expectedOverlap(*first.layer.data->points, *first.place, *second.layer.data->points,
                           *second.place);
}

/// Pairs that may be registered: with a settled member on one side at least.
std::vector<Pairing::Candidate> Pairing::candidates(bool forUnsettled) {
    const double least = scene_.registration.real("pair_overlap");
    std::vector<Candidate> list;
    for (std::size_t a = 0; a < found_.members.size(); ++a)
        for (std::size_t b = a + 1; b < found_.members.size(); ++b) {
            const Member& first = found_.members[a];
            const Member& second = found_.members[b];
            if ((first.fixed && second.fixed) || !first.place || !second.place || isDone(a, b)) continue;
            const bool oneUnsettled = first.settled != second.settled;
            if (forUnsettled ? !oneUnsettled : !(first.settled && second.settled)) continue;
            if (const double share = overlap(a, b); share >= least) list.push_back({a, b, share});
        }
    if (forUnsettled)
        std::stable_sort(list.begin(), list.end(),
                         [](const Candidate& a, const Candidate& b) { return a.overlap > b.overlap; });
    return list;
}

Result<bool> Pairing::registerAgain(const Candidate& candidate, const JobControl& control) {
    const auto extent = [&](std::size_t i) {
        const Member& member = found_.members[i];
        return member.place->scale * member.layer.data->points->bounds().diagonal();
    };
    // The larger one is the target; the case's target always.
    const bool secondIsTarget = found_.members[candidate.b].layer.id == scene_.target;
    const bool firstIsTarget = found_.members[candidate.a].layer.id == scene_.target;
    const bool turn = secondIsTarget || (!firstIsTarget && extent(candidate.b) > extent(candidate.a));
    const std::size_t to = turn ? candidate.b : candidate.a;
    const std::size_t from = turn ? candidate.a : candidate.b;
    const Member& first = found_.members[to];
    const Member& second = found_.members[from];
    std::optional<double> error_m;
    if ((first.fixed || first.error_m) && (second.fixed || second.error_m))
        error_m = std::hypot(first.error_m.value_or(0), second.error_m.value_or(0));
    auto pair = registerFromPlaces(to, from, error_m, control);
    if (!pair) return fail(pair.error());
    tried_.emplace_back(to, from);
    const bool works = pair->result.has_value();
    const std::size_t unsettled = first.settled ? from : to;
    if (works && !found_.members[unsettled].settled) {
        Member& member = found_.members[unsettled];
        const RegistrationResult& result = *pair->result;
        member.place->pose = unsettled == from ? first.place->pose * result.targetFromSource.pose
                                               : second.place->pose * result.targetFromSource.pose.inverse();
        member.error_m = result.rmse_m;
        member.settled = true;
        // Now that it has a place, other pairs deserve another attempt.
        std::erase_if(tried_,
                      [&](const auto& one) { return one.first == unsettled || one.second == unsettled; });
    }
    enter(std::move(*pair));
    return works;
}

Status Pairing::placeThroughOthers(const JobControl& control, bool& progress) {
    // From their first poses, as far as those are known.
    for (auto list = candidates(true); !list.empty(); list = candidates(true)) {
        const auto done = registerAgain(list.front(), next(control));
        if (!done) return fail(done.error());
        progress = progress || *done;
    }
    // By searching the place in each of those that have one.
    for (std::size_t i = 0; i < found_.members.size(); ++i) {
        if (found_.members[i].place || !std::holds_alternative<InitAuto>(found_.members[i].layer.init))
            continue;
        for (std::size_t other = 0; other < found_.members.size() && !found_.members[i].settled; ++other) {
            const Member& reference = found_.members[other];
            if (other == i || !reference.settled || isDone(i, other) || reference.layer.id == scene_.target)
                continue;
            tried_.emplace_back(other, i);
            const auto done = registerFirst(i, other, next(control));
            if (!done) return fail(done.error());
            progress = progress || *done;
        }
        if (!found_.members[i].settled) found_.members[i].place.reset();
    }
    return {};
}

Status Pairing::place(const JobControl& control) {
    for (bool progress = true; progress;) {
        progress = false;
        if (const Status done = placeFromFirstPoses(control, progress); !done) return done;
        if (const Status done = placeThroughOthers(control, progress); !done) return done;
    }
    return {};
}

Status Pairing::pairUp(const JobControl& control) {
    const auto list = candidates(false);
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (control.cancelled()) return fail(cancelledError());
        const auto count = static_cast<double>(list.size());
        const auto done = registerAgain(
            list[i], control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
        if (!done) return fail(done.error());
    }
    return {};
}

/// From the places found so far.
Result<MemberPair> Pairing::registerFromPlaces(std::size_t to, std::size_t from,
                                               std::optional<double> error_m,
                                               const JobControl& control) const {
    const Member& target = found_.members[to];
    const Member& source = found_.members[from];
    MemberPair pair{to, from, {}, {}};
    const InitialPlacement placement{{target.place->pose.inverse() * source.place->pose, source.place->scale},
                                     kPairReach_m + 3 * error_m.value_or(0.5),
                                     error_m,
                                     {},
                                     {}};
    control.progress(0, source.layer.name + " to " + target.layer.name);
    auto prepared = preparePair(scene_, target.layer, source.layer, placement, control.sub(0, 0.3));
    auto result = prepared ? registerTo(scene_, target.layer, source.layer, std::move(*prepared),
                                        control.sub(0.3, 1), watchOf(source, target))
                           : Result<RegistrationResult>(fail(prepared.error()));
    if (!result && result.error().code != ErrorCode::untrustworthy) return fail(result.error());
    if (!result)
        pair.whyNot = result.error().message;
    else if (!result->trustworthy())
        pair.whyNot = unreliable(*result, source.layer.id).message;
    else
        pair.result = std::move(*result);
    return pair;
}

RegistrationWatch Pairing::watchOf(const Member& source, const Member& target) const {
    RegistrationWatch watch = watches_ ? watches_(source.layer.id) : RegistrationWatch();
    if (!watch || target.layer.id == scene_.target) return watch;
    return [watch, place = *target.place](const RegistrationStep& step) {
        RegistrationStep inScene = step;
        inScene.targetFromSource = placed(place, step.targetFromSource);
        watch(inScene);
    };
}

}  // namespace

Result<PairedLayers> pairLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                PreparedLayers prepared, const JobControl& control,
                                const LayerWatches& watches) {
    if (ids.empty()) return PairedLayers{};
    return guarded("registration", [&]() -> Result<PairedLayers> {
        Pairing pairing(scene, std::move(prepared), watches);
        if (const Status gathered = pairing.gather(ids); !gathered) return fail(gathered.error());
        if (const Status placed = pairing.place(control.sub(0, 0.6)); !placed) return fail(placed.error());
        if (const Status paired = pairing.pairUp(control.sub(0.6, 1)); !paired) return fail(paired.error());
        return pairing.take();
    });
}

}  // namespace vestige
