#include "ui/actions/reactions/ExportReactions.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/AtomicFile.h"
#include "core/pipeline/Reconstruct.h"
#include "core/report/MeasurementsCsv.h"
#include "core/report/QuantitiesCsv.h"
#include "core/scene/SceneInputs.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Outputs.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

/// "case quantities.csv" beside "case measurements.csv"; of a file of another name "NAME quantities.csv".
std::filesystem::path tableBeside(const std::filesystem::path& file, const std::string& word) {
    constexpr std::string_view kWord = "measurements";
    std::string stem = file.stem().string();
    const std::size_t at = stem.rfind(kWord);
    if (at == std::string::npos)
        stem += (stem.empty() ? "" : " ") + word;
    else
        stem.replace(at, kWord.size(), word);
    return file.parent_path() / (stem + file.extension().string());
}

}  // namespace

ExportReactions::ExportReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    bench_.actions.onTriggered("export.report", [this] {
        const auto beside = toQt(bench_.document.state().file.parent_path());
        const QString folder = bench_.chooser->folderForReport(&bench_.window, beside);
        if (!folder.isEmpty()) exportReport(toPath(folder));
    });
    bench_.actions.onTriggered("export.csv", [this] {
        const QString file =
            bench_.chooser->csvToSave(&bench_.window, bench_.document.title() + " measurements.csv");
        if (!file.isEmpty()) exportCsv(toPath(file));
    });
}

void ExportReactions::exportReport(const std::filesystem::path& folder) {
    bench_.jobs.run<Reconstruction>(
        tr("Writing the report"),
        [scene = bench_.document.state(), folder, renderer = bench_.renderer, printer = bench_.printer](
            const JobControl& control) { return reconstruct(scene, folder, renderer, printer, control); },
        [this, folder](Result<Reconstruction> made) {
            if (!made) return bench_.notices.failed(made.error());
            bench_.outputs.add(Outputs::Kind::report, toQt(folder));
            QString sentence = tr("The report and %1 files are in %2.")
                                   .arg(made->outputs.size())
                                   .arg(toQt(folder.filename()));
            if (!made->warnings.empty()) sentence += " " + said(made->warnings.front());
            bench_.notices.informOf(sentence, toQt(folder));
        });
}

void ExportReactions::exportCsv(const std::filesystem::path& file) {
    bench_.jobs.run<std::vector<std::filesystem::path>>(
        tr("Writing %1").arg(toQt(file.filename())),
        [scene = bench_.document.state(), shown = bench_.document.measured(),
         all = bench_.document.uncomputed().empty(),
         file](const JobControl&) -> Result<std::vector<std::filesystem::path>> {
            // What is found in clouds may have been cancelled.
            const MeasuredScene measured = all ? shown : measureScene(scene);
            std::vector<std::pair<std::filesystem::path, std::string>> tables{
                {file, measurementsCsv(measured)}};
            const bool figures =
                std::any_of(measured.kinds.begin(), measured.kinds.end(),
                            [](const MeasuredKind& kind) { return !kind.quantities.empty(); });
            if (figures) {
                tables.emplace_back(tableBeside(file, "quantities"), quantitiesCsv(measured));
                tables.emplace_back(tableBeside(file, "uncertainty"), uncertaintyCsv(measured));
            }
            std::vector<std::filesystem::path> written;
            for (const auto& [path, text] : tables)
                if (const Status apart = isNoInput(scene, path); !apart) return fail(apart.error());
            for (const auto& [path, text] : tables) {
                if (const Status done = writeTextFile(path, text); !done) return fail(done.error());
                written.push_back(path);
            }
            return written;
        },
        [this, file](const Result<std::vector<std::filesystem::path>>& written) {
            if (!written) return bench_.notices.failed(written.error());
            bench_.outputs.add(Outputs::Kind::table, toQt(file));
            const QString sentence =
                written->size() < 3
                    ? tr("The measurements are in %1.").arg(toQt(file.filename()))
                    : tr("The measurements are in %1, every figure of each object in %2, what its "
                         "uncertainty is "
                         "made of in %3.")
                          .arg(toQt(written->at(0).filename()), toQt(written->at(1).filename()),
                               toQt(written->at(2).filename()));
            bench_.notices.informOf(sentence, toQt(file));
        });
}

}  // namespace vestige
