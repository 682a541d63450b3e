#include "core/report/CheckBlocks.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/report/CaseReport.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

/// Methods that measured something, in their order.
std::vector<std::string> measuredMethods(const MeasuredScene& measured) {
    std::vector<std::string> methods;
    for (const MeasuredLength& length : measured.lengths)
        if (length.length && std::find(methods.begin(), methods.end(), length.method) == methods.end())
            methods.push_back(length.method);
    return methods;
}

std::vector<std::string> methodsThatAre(const MeasuredScene& measured, Verification wanted) {
    std::vector<std::string> methods;
    for (const std::string& method : measuredMethods(measured))
        if (verification(measured.checks, method) == wanted) methods.push_back(method);
    return methods;
}

}  // namespace

std::vector<std::string> failedChecks(const MeasuredScene& measured) {
    std::vector<std::string> sentences;
    for (const DistanceCheck& check : measured.checks)
        if (check.verdict == DistanceCheck::Verdict::failed)
            sentences.push_back("known distance failed: " + check.object + " by " + check.method + " is " +
                                exactText(check.reference_m) + " m and was measured as " +
                                fixedText(*check.measured_m, 4) + " m, " +
                                fixedText(1000 * *check.difference_m, 1) + " mm off where " +
                                fixedText(1000 * check.tolerance_m, 1) + " mm are allowed");
    return sentences;
}

namespace {

/// Parted so that each name is translated as one (core/base/Translation).
std::string inARow(const std::vector<std::string>& methods) {
    std::string text;
    for (const std::string& method : methods) text += (text.empty() ? "" : "; ") + method;
    return text;
}

}  // namespace

std::string verificationSentence(const MeasuredScene& measured) {
    const auto failed = methodsThatAre(measured, Verification::failed);
    const auto checked = methodsThatAre(measured, Verification::verified);
    const auto open = methodsThatAre(measured, Verification::notChecked);
    std::string text;
    if (!failed.empty())
        text += "WARNING: the check against a known distance FAILED for " + inARow(failed) +
                ". Figures of this report by " + (failed.size() == 1 ? "this method" : "these methods") +
                " must not be relied on until the cause is found. ";
    if (!checked.empty())
        text += "The scale of what " + inARow(checked) +
                " measured is verified: it agrees with the known distance at the scene within the tolerance "
                "set for it. ";
    if (!open.empty() || (failed.empty() && checked.empty()))
        text += (open.empty() ? std::string("The survey") : "What " + inARow(open) + " measured") +
                " was not verified: no known distance at the scene was measured with it. ";
    text.pop_back();
    return text;
}

Section checkSection(const ReportInput& input) {
    Section section{"Check against known distances", {}};
    const auto& checks = input.measured.checks;
    if (checks.empty()) return section;
    section.blocks.push_back(Paragraph{verificationSentence(input.measured)});
    Table table;
    table.caption = "Known distances at the scene";
    table.columns = {"Object",     "Method",          "Known (m)",      "Measured (m)",
                     "U 95 % (m)", "Difference (mm)", "Tolerance (mm)", "Result"};
    table.numeric = {false, false, true, true, true, true, true, false};
    for (const DistanceCheck& check : checks) {
        if (check.verdict == DistanceCheck::Verdict::failed) table.emphasised.push_back(table.rows.size());
        const auto shown = [](const std::optional<double>& value, double scale, int decimals) {
            return orDash(value ? std::optional(fixedText(scale * *value, decimals)) : std::nullopt);
        };
        const bool failed = check.verdict == DistanceCheck::Verdict::failed;
        table.rows.push_back({check.object, check.method, exactText(check.reference_m),
                              shown(check.measured_m, 1, 4), shown(check.expandedUncertainty_m, 1, 4),
                              shown(check.difference_m, 1000, 1), fixedText(1000 * check.tolerance_m, 1),
                              failed ? "FAILED" : std::string(name(check.verdict))});
    }
    section.blocks.push_back(std::move(table));
    section.blocks.push_back(
        Paragraph{"A known distance (a scale bar, or a distance taped at the scene) is measured in the cloud "
                  "like every other object. It passes when the difference is not larger than the tolerance "
                  "set for it; only then is the word \u201cverified\u201d used."});
    for (const DistanceCheck& check : checks)
        if (!check.note.empty())
            section.blocks.push_back(Paragraph{check.object + ", " + check.method + ": " + check.note + "."});
    return section;
}

}  // namespace vestige
