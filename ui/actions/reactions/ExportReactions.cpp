#include "ui/actions/reactions/ExportReactions.h"

#include "core/base/AtomicFile.h"
#include "core/pipeline/Reconstruct.h"
#include "core/report/MeasurementsCsv.h"
#include "core/scene/SceneInputs.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Outputs.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {

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
    bench_.jobs.run<bool>(
        tr("Writing %1").arg(toQt(file.filename())),
        [scene = bench_.document.state(), measured = bench_.document.measured(),
         file](const JobControl&) -> Result<bool> {
            if (const Status apart = isNoInput(scene, file); !apart) return fail(apart.error());
            if (const Status written = writeTextFile(file, measurementsCsv(measured)); !written)
                return fail(written.error());
            return true;
        },
        [this, file](Result<bool> written) {
            if (!written) return bench_.notices.failed(written.error());
            bench_.outputs.add(Outputs::Kind::table, toQt(file));
            bench_.notices.informOf(tr("The measurements are in %1.").arg(toQt(file.filename())), toQt(file));
        });
}

}  // namespace vestige
