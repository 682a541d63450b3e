#include <algorithm>

#include "core/report/CaseReport.h"
#include "core/report/Wording.h"

namespace vestige {

Section notesSection(const ReportInput& input) {
    Section section{"Notes and warnings", {}};
    Facts notes;
    const auto add = [&](const std::string& subject, const std::string& text) {
        const std::pair<std::string, std::string> row{subject, text};
        if (!text.empty() && std::find(notes.rows.begin(), notes.rows.end(), row) == notes.rows.end())
            notes.rows.push_back(row);
    };
    for (const auto& warning : input.warnings) add("This run", warning);
    for (const auto& layer : input.scene.layers)
        if (layer.data)
            for (const auto& warning : layer.data->info.warnings)
                add("File " + layer.path.filename().string(), warning);
    for (const auto& length : input.measured.lengths)
        if (!length.note.empty() || !length.length)
            add(length.object + ", " + length.method, length.note.empty() ? "not measurable" : length.note);
    for (const auto& method : input.measured.accuracy)
        if (method.systematic)
            add("Method " + method.name,
                "the relative errors are systematic (mean " + signedPercent(method.meanRe) +
                    " %): a common cause, such as a wrong scale, is likelier than chance");
    if (!notes.rows.empty()) section.blocks.push_back(std::move(notes));
    return section;
}

}  // namespace vestige
