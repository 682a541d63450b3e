#include "core/report/CaseReport.h"
#include "core/report/Wording.h"

namespace vestige {

Section originSection(const ReportInput& input) {
    Section section{"Software and times", {}};
    Table versions;
    versions.caption = "Software";
    versions.columns = {"Component", "Version"};
    versions.numeric = {false, false};
    for (const auto& [component, version] : input.versions) versions.rows.push_back({component, version});
    if (!versions.rows.empty()) section.blocks.push_back(std::move(versions));

    Table times;
    times.caption = "Time taken by each stage";
    times.columns = {"Stage", "Time", "Minutes"};
    times.numeric = {false, true, true};
    double total = 0;
    for (const auto& stage : input.stages) {
        times.rows.push_back({stage.title, duration(stage.seconds), minutes(stage.seconds)});
        total += stage.seconds;
    }
    if (!times.rows.empty()) {
        times.rows.push_back({"Together, until this report", duration(total), minutes(total)});
        section.blocks.push_back(std::move(times));
    }
    section.blocks.push_back(Paragraph{
        "The same files and parameters give the same results, bit for bit, on every run and for any number "
        "of processor cores; "
        "times and dates alone differ. manifest.json lists the SHA-256 values of all inputs and results."});
    return section;
}

}  // namespace vestige
