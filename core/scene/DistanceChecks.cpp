#include <cmath>

#include "core/base/Numbers.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {
namespace {

void addNote(std::string& note, const std::string& sentence) {
    note += (note.empty() ? "" : "; ") + sentence;
}

/// ASTM E3125 asks of an artefact that it is known four times better than what it is to show.
void judge(DistanceCheck& check, const MeasuredLength& row) {
    if (!row.length) return;
    check.measured_m = row.length->mean_m;
    check.expandedUncertainty_m = row.length->expandedUncertainty_m;
    check.difference_m = *check.measured_m - check.reference_m;
    check.verdict = std::abs(*check.difference_m) <= check.tolerance_m ? DistanceCheck::Verdict::passed
                                                                       : DistanceCheck::Verdict::failed;
    if (4 * 2 * row.tapeUncertainty_m > check.tolerance_m)
        addNote(check.note, "the reference is not known four times better than the tolerance");
    if (!check.expandedUncertainty_m)
        addNote(check.note, "one repeat only");
    else if (*check.expandedUncertainty_m > check.tolerance_m)
        addNote(check.note, "the uncertainty of the measured length, " +
                                fixedText(1000 * *check.expandedUncertainty_m, 1) +
                                " mm, is larger than the tolerance");
}

}  // namespace

std::string_view name(DistanceCheck::Verdict verdict) {
    switch (verdict) {
        case DistanceCheck::Verdict::passed:
            return "passed";
        case DistanceCheck::Verdict::failed:
            return "failed";
        case DistanceCheck::Verdict::notMeasured:
            return "not measured";
    }
    return "not measured";
}

std::string_view name(Verification verification) {
    switch (verification) {
        case Verification::notChecked:
            return "not verified";
        case Verification::failed:
            return "failed";
        case Verification::verified:
            return "verified";
    }
    return "not verified";
}

std::vector<DistanceCheck> distanceChecks(const SceneState& scene,
                                          const std::vector<MeasuredLength>& lengths) {
    std::vector<DistanceCheck> checks;
    for (const MeasuredLength& row : lengths) {
        const Measurement* measurement = scene.measurement(row.object);
        if (!measurement || !measurement->checkTolerance_m || !measurement->tape_m) continue;
        DistanceCheck check{row.object, row.method, *measurement->tape_m, *measurement->checkTolerance_m};
        judge(check, row);
        checks.push_back(std::move(check));
    }
    return checks;
}

Verification verification(const std::vector<DistanceCheck>& checks, const std::string& method) {
    bool passed = false;
    for (const DistanceCheck& check : checks) {
        if (check.method != method) continue;
        if (check.verdict == DistanceCheck::Verdict::failed) return Verification::failed;
        passed = passed || check.verdict == DistanceCheck::Verdict::passed;
    }
    return passed ? Verification::verified : Verification::notChecked;
}

Verification verification(const MeasuredScene& measured) {
    bool any = false, all = true;
    for (const MeasuredLength& row : measured.lengths) {
        if (!row.length) continue;
        const Verification one = verification(measured.checks, row.method);
        if (one == Verification::failed) return one;
        any = true;
        all = all && one == Verification::verified;
    }
    return any && all ? Verification::verified : Verification::notChecked;
}

}  // namespace vestige
