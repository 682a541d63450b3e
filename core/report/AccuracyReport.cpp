#include "core/report/AccuracyReport.h"

#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Version.h"
#include "core/report/ReChartData.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

std::string percentOrDash(const std::optional<double>& fraction, int decimals = 2) {
    return orDash(fraction ? std::optional(fixedText(100 * *fraction, decimals)) : std::nullopt);
}

Table summaryTable(const std::vector<MethodAccuracy>& methods) {
    Table table;
    table.caption = "Accuracy of each method against the tape";
    table.columns = {"Method",         "Objects", "SD of RE (%)", "RMSE (%)", "RMSE, all objects (%)",
                     "RMSE, all (mm)", "Excluded"};
    table.numeric = {false, true, true, true, true, true, false};
    for (const auto& method : methods)
        table.rows.push_back(
            {method.name, std::to_string(method.n), percentOrDash(method.sd), percentOrDash(method.rmse),
             percentOrDash(method.rmseAll),
             orDash(method.rmseAbsolute_m ? std::optional(fixedText(1000 * *method.rmseAbsolute_m, 1))
                                          : std::nullopt),
             method.excluded.empty() ? "none" : listed(method.excluded)});
    return table;
}

Table objectTable(const MethodAccuracy& method) {
    Table table;
    table.caption = "Objects measured by " + method.name;
    table.columns = {"Object", "Tape (m)", "Measured (m)", "Difference (mm)", "RE (%)", "Counts"};
    table.numeric = {false, true, true, true, true, false};
    for (const auto& object : method.objects) {
        if (object.excluded) table.emphasised.push_back(table.rows.size());
        const bool measured = object.measured_m.has_value();
        const double difference = measured ? 1000 * (*object.measured_m - object.tape_m) : 0;
        table.rows.push_back(
            {object.object, exactText(object.tape_m), measured ? fixedText(*object.measured_m, 4) : "\u2013",
             measured ? (difference < 0 ? "\u2212" : "+") + fixedText(std::abs(difference), 1) : "\u2013",
             object.re ? signedPercent(*object.re) : "\u2013",
             !measured         ? "not measurable"
             : object.excluded ? "excluded"
                               : "yes"});
    }
    return table;
}

std::string verdict(const MethodAccuracy& method) {
    if (method.n == 0) return "";
    std::string text = "By " + method.name + ", " + howMany(method.n, "object") +
                       (method.n == 1 ? " was" : " were") + " measured. ";
    if (method.systematic)
        return text +
               "The rule would have excluded half of the objects or more, so none was excluded: the errors "
               "are "
               "systematic, not scattered; their mean is " +
               signedPercent(method.meanRe) + " %.";
    if (!method.sd)
        return text +
               "With fewer than two objects there is no standard deviation and nothing can be excluded.";
    if (method.excluded.empty())
        return text + "No relative error lies beyond twice their standard deviation, so none was excluded.";
    return text + "Excluded, because the relative error lies beyond twice the standard deviation: " +
           listed(method.excluded) + ". The RMSE of all objects, these included, stands beside the other.";
}

}  // namespace

std::vector<Block> accuracyBlocks(const std::vector<MethodAccuracy>& methods) {
    std::vector<Block> blocks;
    if (methods.empty()) return blocks;
    blocks.push_back(Paragraph{
        "The tape measure is the baseline. The relative error (RE) of an object is its measured length minus "
        "its tape "
        "length, divided by the tape length: +2 % means measured 2 % too long. SD is the standard deviation "
        "of these "
        "relative errors. An object whose RE is larger than twice the SD, either way, is excluded once; the "
        "root mean "
        "square error (RMSE) is the square root of the mean of the squared RE of the others. RE, SD and RMSE "
        "are "
        "proportions, not lengths; the RMSE of the differences in millimetres is given beside them."});
    blocks.push_back(summaryTable(methods));
    for (const auto& method : methods)
        if (const std::string text = verdict(method); !text.empty()) blocks.push_back(Paragraph{text});
    for (const auto& method : methods)
        if (!method.small.empty())
            blocks.push_back(Paragraph{
                "By " + method.name +
                ", smaller than three spots of the beam that measured them: " + listed(method.small) +
                ". Of these the scan shows the beam as much as the object. The RMSE of the others is " +
                percentOrDash(method.rmseLarge) + " %."});
    for (auto& chart : relativeErrorCharts(methods)) {
        chart.caption += ". Hollow bars are excluded objects; n/m: not measurable by that method.";
        blocks.push_back(std::move(chart));
    }
    for (const auto& method : methods)
        if (!method.objects.empty()) blocks.push_back(objectTable(method));
    return blocks;
}

Report accuracyReport(const std::vector<MethodAccuracy>& methods, const std::string& tableName,
                      const std::string& date) {
    Report report;
    report.title = "Accuracy report";
    report.subtitle = "Measured lengths against the tape: " + tableName;
    report.date = readableDate(date);
    report.software = std::string("Vestige ") + kVersion;
    report.sections.push_back({"Accuracy against the tape", accuracyBlocks(methods)});
    for (const auto& method : methods)
        for (const auto& object : method.objects) report.names.push_back(object.object);
    return report;
}

}  // namespace vestige
