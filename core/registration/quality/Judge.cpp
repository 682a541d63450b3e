#include "core/registration/quality/Judge.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/base/Units.h"

namespace vestige {
namespace {

std::string percent(double share) {
    return fixedText(100 * share, 0) + " %";
}

std::string lengthText(double metres) {
    return metres < 1 ? fixedText(1000 * metres, metres < 0.01 ? 1 : 0) + " mm" : fixedText(metres, 2) + " m";
}

class Reasons {
  public:
    void fail(const std::string& reason) {
        failed_ = true;
        failures_.push_back(reason);
    }
    void doubt(const std::string& reason) { doubts_.push_back(reason); }
    Judgement judgement() && {
        Judgement result;
        result.verdict = failed_ ? Verdict::failed : doubts_.empty() ? Verdict::accepted : Verdict::doubtful;
        result.reasons = std::move(failures_);
        result.reasons.insert(result.reasons.end(), doubts_.begin(), doubts_.end());
        return result;
    }

  private:
    bool failed_ = false;
    std::vector<std::string> failures_;
    std::vector<std::string> doubts_;
};

void judgeOverlap(const RegistrationResult& result, const QualityOptions& options, Reasons& reasons) {
    constexpr double kOverlapIfNotConverged = 0.3;
    // Either cloud may be the small one, so the better of the two counts.
    const double overlap = std::max(result.overlap, result.targetOverlap);
    if (!(overlap >= options.leastOverlap))
        reasons.fail("only " + percent(result.overlap) + " of the source lies within " +
                     lengthText(result.inlierDistance_m) + " of the target");
    else if (!result.converged && overlap < kOverlapIfNotConverged)
        reasons.fail("it has not converged and only " + percent(result.overlap) +
                     " of the source lies on the target");
    else if (!result.converged)
        reasons.doubt("the limit of steps was reached before it settled");
}

void judgeSupport(const Evidence& evidence, const QualityOptions& options, Reasons& reasons) {
    constexpr double kSeenPerSupport = 1.4;  // the part that both clouds saw agrees the better
    // Surface that one cloud lacks speaks against a pose less where rays say that it is free there.
    const double share = evidence.freeSpaceKnown ? 0.5 : 1;
    const double support = std::max(evidence.source.support, evidence.target.support);
    const double seen = std::max(evidence.source.seenSupport, evidence.target.seenSupport);
    if (!(support >= options.failedSupport && seen >= kSeenPerSupport * options.failedSupport))
        reasons.fail("the surfaces that would hold the pose disagree: in one direction only " +
                     percent(support) + " of them lie on the other cloud (" + percent(seen) +
                     " where both clouds have surface)");
    else if (!(support >= share * options.doubtfulSupport &&
               seen >= kSeenPerSupport * options.doubtfulSupport))
        reasons.doubt("few of the surfaces that would hold the pose agree: in one direction " +
                      percent(support) + " (" + percent(seen) + " where both clouds have surface)");
}

void judgeFreeSpace(const Evidence& evidence, const QualityOptions& options, Reasons& reasons) {
    const auto reason = [&] {
        return "a scanner has seen through the place of " + fixedText(100 * evidence.through, 1) +
               " % of the surface that this pose puts before it";
    };
    if (!(evidence.through <= options.failedSeenThrough))
        reasons.fail(reason());
    else if (!(evidence.through <= options.doubtfulSeenThrough))
        reasons.doubt(reason());
}

void judgeObservability(const RegistrationQuality& quality, const Evidence& evidence,
                        const QualityOptions& options, Reasons& reasons) {
    bool free = false;
    for (const ObservedDirection& direction : quality.directions) {
        if (!direction.free) continue;
        free = true;
        reasons.doubt("the data do not hold the scan: it " + direction.words);
    }
    if (free) return;
    if (!(evidence.shift.size <= options.doubtfulUncertainty_m))
        reasons.doubt("the pose is uncertain by " + lengthText(evidence.shift.size) +
                      " (95 %) where it is held least: it " + evidence.shift.words);
    // A small thing may turn by more before its surface moves.
    if (!(degrees(evidence.turn.size) <= options.doubtfulTurn_deg) &&
        !(evidence.turn.size * evidence.radius_m <= options.doubtfulUncertainty_m))
        reasons.doubt("the pose is uncertain by " + fixedText(degrees(evidence.turn.size), 2) +
                      " degrees (95 %) where it is held least: it " + evidence.turn.words);
}

void judgeRivals(const Evidence& evidence, Reasons& reasons) {
    constexpr double kNearlyAsGood = 0.5;
    constexpr double kAsGood = 0.95;
    constexpr double kBetter = 1.05;
    const Rival* better = nullptr;
    const Rival* clear = nullptr;
    const Rival* alike = nullptr;
    const auto keep = [](const Rival*& best, const Rival& one) {
        if (!best || one.score > best->score) best = &one;
    };
    for (const Rival& rival : evidence.rivals) {
        if (rival.away_m < evidence.apart_m || clearer(evidence.through, rival.through)) continue;
        // From behind, a hall may look better by chance of where the stations stood.
        if (rival.perturbed && rival.score > kBetter * evidence.score) keep(better, rival);
        if (rival.score > kNearlyAsGood * evidence.score && clearer(rival.through, evidence.through))
            keep(clear, rival);
        if (rival.score > kAsGood * evidence.score) keep(alike, rival);
    }
    if (better)
        reasons.fail("another start led to a pose " + lengthText(better->away_m) + " away that fits better");
    if (clear)
        reasons.fail("a pose " + lengthText(clear->away_m) +
                     " away fits, too, and of its surface a scanner has seen through " +
                     fixedText(100 * clear->through, 1) + " % only, of this one's " +
                     fixedText(100 * evidence.through, 1) + " %");
    if (alike && !better && !clear)
        reasons.doubt("a pose " + lengthText(alike->away_m) + " away fits as well");
}

void judgeRestarts(const RegistrationQuality& quality, Reasons& reasons) {
    if (2 * quality.restarts.agreeing < quality.restarts.runs)
        reasons.doubt("only " + std::to_string(quality.restarts.agreeing) + " of " +
                      std::to_string(quality.restarts.runs) + " perturbed starts came back to this pose");
}

}  // namespace

bool clearer(double through, double otherThrough) {
    constexpr double kTimes = 3;
    constexpr double kChance = 0.003;
    return otherThrough > kTimes * through + kChance;
}

Judgement judge(const RegistrationResult& result, const RegistrationQuality& quality,
                const Evidence& evidence, const QualityOptions& options) {
    Reasons reasons;
    judgeOverlap(result, options, reasons);
    judgeSupport(evidence, options, reasons);
    judgeFreeSpace(evidence, options, reasons);
    judgeObservability(quality, evidence, options, reasons);
    judgeRivals(evidence, reasons);
    judgeRestarts(quality, reasons);
    Judgement judgement = std::move(reasons).judgement();
    if (judgement.verdict == Verdict::accepted)
        judgement.reasons.push_back(percent(std::max(evidence.source.agrees, evidence.target.agrees)) +
                                    " of the surface agrees, every direction is held" +
                                    (quality.restarts.runs > 0
                                         ? " and " + std::to_string(quality.restarts.agreeing) + " of " +
                                               std::to_string(quality.restarts.runs) +
                                               " perturbed starts came back to this pose"
                                         : ""));
    return judgement;
}

}  // namespace vestige
