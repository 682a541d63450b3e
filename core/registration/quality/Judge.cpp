#include "core/registration/quality/Judge.h"

#include <algorithm>

#include "core/base/Numbers.h"

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
    if (overlap < options.leastOverlap)
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
    const double support = std::max(evidence.source.support, evidence.target.support);
    const double seen = std::max(evidence.source.seenSupport, evidence.target.seenSupport);
    if (support < options.failedSupport || seen < kSeenPerSupport * options.failedSupport)
        reasons.fail("the surfaces that would hold the pose disagree: in one direction only " +
                     percent(support) + " of them lie on the other cloud (" + percent(seen) +
                     " where both clouds have surface)");
    else if (support < options.doubtfulSupport || seen < kSeenPerSupport * options.doubtfulSupport)
        reasons.doubt("few of the surfaces that would hold the pose agree: in one direction " +
                      percent(support) + " (" + percent(seen) + " where both clouds have surface)");
}

void judgeObservability(const RegistrationQuality& quality, const Evidence& evidence,
                        const QualityOptions& options, Reasons& reasons) {
    bool free = false;
    for (const ObservedDirection& direction : quality.directions) {
        if (!direction.free) continue;
        free = true;
        reasons.doubt("the data do not hold the scan: it " + direction.words);
    }
    if (!free && evidence.longestHalfAxis_m > options.doubtfulUncertainty_m)
        reasons.doubt("the pose is uncertain by " + lengthText(evidence.longestHalfAxis_m) +
                      " (95 %) where it is held least: it " + quality.directions.front().words);
}

void judgeRestarts(const RegistrationQuality& quality, const Evidence& evidence, Reasons& reasons) {
    if (evidence.betterElsewhere_m) {
        const std::string where =
            "another start led to a pose " + lengthText(*evidence.betterElsewhere_m) + " away that fits ";
        if (evidence.muchBetter)
            reasons.fail(where + "better");
        else
            reasons.doubt(where + "as well");
    } else if (2 * quality.restarts.agreeing < quality.restarts.runs) {
        reasons.doubt("only " + std::to_string(quality.restarts.agreeing) + " of " +
                      std::to_string(quality.restarts.runs) + " perturbed starts came back to this pose");
    }
}

}  // namespace

Judgement judge(const RegistrationResult& result, const RegistrationQuality& quality,
                const Evidence& evidence, const QualityOptions& options) {
    Reasons reasons;
    judgeOverlap(result, options, reasons);
    judgeSupport(evidence, options, reasons);
    judgeObservability(quality, evidence, options, reasons);
    judgeRestarts(quality, evidence, reasons);
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
