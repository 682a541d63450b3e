#include "ui/actions/reactions/SampleReactions.h"

#include <QDir>

#include "core/base/AtomicFile.h"
#include "core/simulation/SimulateScene.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Notices.h"
#include "ui/document/SampleCase.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

constexpr const char* kScene = "bicycle";

/// The case's path.
Result<QString> makeSample(const QString& folder, const JobControl& control) {
    if (!QDir().mkpath(folder))
        return fail(ErrorCode::output, "the folder of the sample case cannot be made", folder.toStdString());
    const Result<SceneSpec> spec = sceneSpec(kScene);
    if (!spec) return fail(spec.error());
    const auto made = simulateScene(*spec, {}, toPath(folder), control);
    if (!made) return fail(made.error());
    if (const Status marked = writeTextFile(toPath(sampleMark(folder)), {}); !marked)
        return fail(marked.error());
    return folder + "/case.json";
}

}  // namespace

SampleReactions::SampleReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    bench_.actions.onTriggered("file.sample", [this] {
        const QString there = sampleCase();
        if (there.isEmpty())
            simulate();
        else
            emit ready(there);
    });
}

void SampleReactions::simulate() {
    bench_.notices.inform(tr("The sample scene is simulated once; that takes some minutes."));
    bench_.jobs.run<QString>(
        tr("Simulating the sample scene"),
        [folder = sampleFolder()](const JobControl& control) { return makeSample(folder, control); },
        [this](Result<QString> made) {
            if (!made) return bench_.notices.failed(made.error());
            emit ready(*made);
        });
}

}  // namespace vestige
