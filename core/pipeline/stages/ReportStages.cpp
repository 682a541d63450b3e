#include <algorithm>

#include "core/base/AtomicFile.h"
#include "core/base/Hash.h"
#include "core/base/Translation.h"
#include "core/pipeline/Manifest.h"
#include "core/pipeline/ReconstructRun.h"
#include "core/report/CaseReport.h"
#include "core/report/TranslateReport.h"

namespace vestige {

Status reportStage(ReconstructRun& run, const JobControl& control) {
    if (!run.printer) {
        run.notMade.push_back("report.pdf");
        return {};
    }
    const ReportInput input{run.scene,    run.measured,
                            run.warnings, run.pictures,
                            run.stages,   softwareVersions(run.renderer, run.printer),
                            run.date,     run.adjustment ? &*run.adjustment : nullptr};
    return run.printer->printPdf(translated(caseReport(input), language()), run.output.path("report.pdf"),
                                 control);
}

Status manifestStage(ReconstructRun& run, const JobControl& control) {
    auto outputs = hashedOutputs(run.output, control);
    if (!outputs) return fail(outputs.error());
    constexpr const char* kManifest = "manifest.json";
    const std::string text = manifestText(run, *outputs);
    run.outputs = std::move(*outputs);
    const auto after = std::find_if(run.outputs.begin(), run.outputs.end(),
                                    [&](const OutputFile& file) { return file.path > kManifest; });
    Sha256 hash;
    hash.add(text);
    run.outputs.insert(after, {kManifest, hash.hex()});
    return writeTextFile(run.output.path(kManifest), text);
}

}  // namespace vestige
