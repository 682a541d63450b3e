#include "core/report/CaseReport.h"

#include <array>

#include "core/base/Version.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

std::vector<std::string> namesOf(const ReportInput& input) {
    std::vector<std::string> names{input.scene.name, input.scene.operatorName};
    for (const Layer& layer : input.scene.layers)
        names.insert(names.end(), {layer.id, layer.name, layer.path.filename().string()});
    for (const Measurement& measurement : input.scene.measurements) names.push_back(measurement.object);
    for (const MeasuredLength& length : input.measured.lengths) names.push_back(length.object);
    return names;
}

}  // namespace

Report caseReport(const ReportInput& input) {
    // A new section is one more line here.
    constexpr std::array sections{summarySection,  caseSection,         inputSection,       cleaningSection,
                                  methodSection,   registrationSection, lengthSection,      kindSection,
                                  accuracySection, checkSection,        uncertaintySection, notesSection,
                                  originSection};
    Report report;
    report.title = "Scene measurement report";
    report.subtitle = "Digital reconstruction of a road-accident scene from laser scans";
    report.caseName = input.scene.name;
    report.operatorName = input.scene.operatorName;
    report.date = readableDate(input.date);
    report.software = std::string("Vestige ") + kVersion;
    for (const auto& make : sections)
        if (Section section = make(input); !section.blocks.empty())
            report.sections.push_back(std::move(section));
    report.names = namesOf(input);
    return report;
}

}  // namespace vestige
