#include <algorithm>

#include "core/base/Numbers.h"
#include "core/measurement/MeasuredText.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/report/CaseReport.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

std::vector<std::string> row(const MeasuredLength& length) {
    const std::string tape = orDash(length.tape_m ? std::optional(exactText(*length.tape_m)) : std::nullopt);
    if (!length.length) return {length.object, length.method, tape, "not measurable", "", "", "", ""};
    const LengthStatistic& statistic = *length.length;
    const auto& u = statistic.expandedUncertainty_m;
    const MeasuredText mean = measuredText(statistic.mean_m, u);
    const auto& sd = statistic.repeatSd_m;
    return {length.object,
            length.method,
            tape,
            mean.value,
            std::to_string(statistic.repeats_m.size()),
            orDash(sd ? std::optional(fixedText(*sd, measuredDecimals(u))) : std::nullopt),
            mean.uncertainty.empty() ? "\u2013" : "\u00b1" + mean.uncertainty,
            length.re ? signedPercent(*length.re) + (length.excluded ? " *" : "") : "\u2013"};
}

/// Those stand beside their figures.
bool isOfPath(const ReportInput& input, const ReportPicture& picture) {
    const Measurement* measurement = input.scene.measurement(picture.subject);
    return measurement && !kindSpec(measurement->kind).isPair();
}

}  // namespace

Section lengthSection(const ReportInput& input) {
    Section section{"Measured lengths", {}};
    if (input.measured.lengths.empty()) return section;
    Table table;
    table.caption = "Lengths by object and method";
    table.columns = {"Object",  "Method",        "Tape (m)",   "Mean (m)",
                     "Repeats", "Repeat SD (m)", "U 95 % (m)", "RE (%)"};
    table.numeric = {false, false, true, true, true, true, true, true};
    bool excluded = false;
    for (const auto& length : input.measured.lengths) {
        if (length.excluded) table.emphasised.push_back(table.rows.size());
        excluded = excluded || length.excluded;
        table.rows.push_back(row(length));
    }
    section.blocks.push_back(
        Paragraph{"A length is the straight distance between two points that were picked in the cloud. Each "
                  "was picked several times "
                  "anew; the mean of the repeats is the result. Repeat SD is the standard deviation of the "
                  "repeats. U 95 % is the "
                  "expanded uncertainty: with a probability of 95 % the true length lies within the mean "
                  "plus or minus U (how it is "
                  "found stands under \u201cUncertainty of the figures\u201d). RE is the relative error "
                  "against the tape."});
    if (std::any_of(input.measured.lengths.begin(), input.measured.lengths.end(),
                    [](const MeasuredLength& length) { return length.fitted; }))
        section.blocks.push_back(Paragraph{
            "Rows of a method named \u201cfitted\u201d take the same picks, but not the single points that "
            "were "
            "hit: round each pick a plane, an edge or another feature was fitted to all points, strays given "
            "no weight, and the length runs between the features. What is known of the scanner is used: its "
            "noise lies along the beam, and an edge is read from the beams that pass along it. A pick round "
            "which nothing was fitted counts as the point it is; the notes name these. Both ways are given, "
            "so "
            "that either can be checked against the other."});
    if (std::any_of(input.measured.lengths.begin(), input.measured.lengths.end(),
                    [&](const MeasuredLength& length) {
                        const Measurement* measurement = input.scene.measurement(length.object);
                        return measurement && measurement->kind != MeasurementKind::distance;
                    }))
        section.blocks.push_back(Paragraph{
            "Of an object that is no straight distance the row gives the main figure of its kind, such as "
            "the "
            "length along a mark or a radius; all its figures stand under \u201cOther figures\u201d."});
    section.blocks.push_back(std::move(table));
    if (excluded)
        section.blocks.push_back(Paragraph{
            "* Set off in the table: excluded from the RMSE, because the relative error lies beyond "
            "twice the standard deviation."});
    for (const auto& picture : input.pictures)
        if (picture.kind == ReportPicture::Kind::closeUp && !isOfPath(input, picture))
            section.blocks.push_back(Picture{picture.png, picture.caption, 0.5});
    return section;
}

}  // namespace vestige
