#include "core/base/Numbers.h"
#include "core/base/Translation.h"
#include "core/report/CaseReport.h"
#include "core/report/CheckBlocks.h"
#include "core/report/Wording.h"
#include "core/scene/FileEvidence.h"

namespace vestige {
namespace {

std::string registrationSentence(const Layer& layer) {
    const auto& result = *layer.registration;
    return "The scan \u201c" + layer.name + "\u201d was fitted to the global cloud; " +
           percent(result.overlap, 0) +
           " of its points found a counterpart, at a root mean square distance of " +
           fixedText(1000 * result.rmse_m, 1) + " mm" +
           (result.converged ? "."
                             : ". The computation reached its limit of steps before it settled: see the "
                               "section on registration.");
}

std::string accuracySentence(const MethodAccuracy& method) {
    std::string text =
        "Measured by " + method.name + ", " + howMany(method.n - method.excluded.size(), "object") +
        " with a tape value show a root mean square relative error of " + percent(method.rmse.value_or(0), 2);
    if (!method.excluded.empty())
        text = text + " (" + percent(method.rmseAll.value_or(0), 2) + " with the excluded " +
               listed(method.excluded) + ")";
    return text + ".";
}

}  // namespace

Section summarySection(const ReportInput& input) {
    Section section{"Summary", {}};
    std::size_t measured = 0;
    std::vector<std::string> missing;
    for (const auto& length : input.measured.lengths) {
        if (length.length)
            ++measured;
        else
            missing.push_back(length.object + " (" + say(length.method) + ")");
    }
    std::string text = "From " + howMany(input.scene.layers.size(), "point cloud") + ", " +
                       howMany(measured, "length") + (measured == 1 ? " was" : " were") + " measured.";
    for (const auto& layer : input.scene.layers)
        if (layer.registration) text += " " + registrationSentence(layer);
    section.blocks.push_back(Paragraph{text});
    for (const auto& method : input.measured.accuracy)
        if (method.n > 0) section.blocks.push_back(Paragraph{accuracySentence(method)});
    section.blocks.push_back(Paragraph{verificationSentence(input.measured)});
    std::vector<std::string> changed;
    std::vector<std::string> partial;
    for (const auto& layer : input.scene.layers) {
        if (evidenceDifference(layer)) changed.push_back(layer.path.filename().string());
        if (layer.data && !layer.data->info.damage.empty()) partial.push_back(layer.path.filename().string());
    }
    if (!changed.empty())
        section.blocks.push_back(Paragraph{"Changed since it became part of the case: " + listed(changed) +
                                           ". See \u201cEvidence used\u201d."});
    if (!partial.empty())
        section.blocks.push_back(Paragraph{"Damaged, and read only in part: " + listed(partial) +
                                           ". See \u201cEvidence used\u201d."});
    if (!missing.empty()) section.blocks.push_back(Paragraph{"Not measurable: " + listed(missing) + "."});
    if (!input.warnings.empty())
        section.blocks.push_back(
            Paragraph{"There " + std::string(input.warnings.size() == 1 ? "is " : "are ") +
                      howMany(input.warnings.size(), "note") +
                      " on this run; they are listed under \u201cNotes and warnings\u201d."});
    return section;
}

}  // namespace vestige
