#include "ui/actions/reactions/ExchangeReactions.h"

#include "core/base/AtomicFile.h"
#include "core/registration/InitialPose.h"
#include "core/scene/Edits.h"
#include "core/scene/SceneInputs.h"
#include "core/scene/picks/DelimitedText.h"
#include "core/scene/picks/PickExchange.h"
#include "core/scene/picks/TapeList.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Outputs.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"

namespace vestige {

ExchangeReactions::ExchangeReactions(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    actions.onTriggered("file.import-picks", [this] {
        const QString file = bench_.chooser->tableToOpen(&bench_.window, tr("Import picks"));
        if (!file.isEmpty()) importPickList(file);
    });
    actions.onTriggered("file.import-measurements", [this] {
        const QString file = bench_.chooser->tableToOpen(&bench_.window, tr("Import tape values"));
        if (!file.isEmpty()) importTapeList(file);
    });
    actions.onTriggered("file.export-picks", [this] {
        const QString file =
            bench_.chooser->csvToSave(&bench_.window, bench_.document.title() + " picks.csv");
        if (!file.isEmpty()) exportPickList(file);
    });
}

void ExchangeReactions::enter(std::vector<Measurement> changed, const QString& description) {
    bench_.document.begin(description);
    for (Measurement& measurement : changed) {
        std::string words = "import " + measurement.object;
        bench_.document.perform(setMeasurement(std::move(measurement), std::move(words)));
    }
    bench_.document.end();
}

bool ExchangeReactions::takeCorrespondences(const QString& file) {
    const auto table = readDelimited(toPath(file));
    if (!table || table->rows.empty() ||
        table->rows.front().cells != std::vector<std::string>{"tx", "ty", "tz", "sx", "sy", "sz"})
        return false;
    const SceneState& scene = bench_.document.state();
    const Layer* layer = scene.layer(bench_.selection.layer());
    if (!layer || layer->id == scene.target) {
        bench_.notices.warn(
            tr("%1 has corresponding points: select the layer that they belong to, which is not "
               "the target, and import them again.")
                .arg(QString::fromStdString(toPath(file).filename().string())));
        return true;
    }
    if (const auto pairs = readPointPairs(toPath(file)); !pairs) {
        bench_.notices.failed(pairs.error());
        return true;
    }
    Layer changed = *layer;
    changed.init = InitPicks{std::filesystem::absolute(toPath(file)), {}};
    bench_.document.perform(changeLayer(std::move(changed), "first pose of " + layer->name));
    bench_.notices.inform(tr("%1 now starts from these pairs; Register (Ctrl+G) goes on from there.")
                              .arg(QString::fromStdString(layer->name)));
    return true;
}

void ExchangeReactions::importPickList(const QString& file) {
    if (takeCorrespondences(file)) return;
    const auto points = readPointList(toPath(file));
    if (!points) return bench_.notices.failed(points.error());
    const SceneState& scene = bench_.document.state();
    PicksTarget target{bench_.selection.object(), bench_.selection.layer()};
    if (!scene.measurement(target.object)) target.object = freeObjectName(scene);
    if (!scene.layer(target.layer)) target.layer = scene.target;
    auto picks = importPicks(scene, *points, target, file.toStdString());
    if (!picks) return bench_.notices.failed(picks.error());
    if (picks->repeats == 0) return bench_.notices.inform(tr("The case has all of these picks already."));
    const std::string first = picks->changed.front().object;
    const auto objects = picks->changed.size();
    enter(std::move(picks->changed), tr("import picks"));
    bench_.selection.setObject(first);
    QString sentence = objects == 1
                           ? tr("%1 repeats of %2 were taken.").arg(picks->repeats).arg(toQt(first))
                           : tr("%1 repeats of %2 objects were taken.").arg(picks->repeats).arg(objects);
    if (picks->known > 0) sentence += " " + tr("%1 were there already.").arg(picks->known);
    bench_.notices.inform(sentence);
}

void ExchangeReactions::importTapeList(const QString& file) {
    const auto rows = readTapeList(toPath(file));
    if (!rows) return bench_.notices.failed(rows.error());
    auto changed = importTapes(bench_.document.state(), *rows);
    if (changed.empty()) return bench_.notices.inform(tr("The case has all of these values already."));
    const auto count = changed.size();
    enter(std::move(changed), tr("import tape values"));
    bench_.actions["view.panel-measure"].trigger();
    bench_.notices.inform(
        tr("%1 objects were added or changed. Measured lengths come of picks and were not taken.")
            .arg(count));
}

void ExchangeReactions::exportPickList(const QString& file) {
    if (const Status apart = isNoInput(bench_.document.state(), toPath(file)); !apart)
        return bench_.notices.failed(apart.error());
    const Status written = writeTextFile(toPath(file), picksCsv(bench_.document.state()));
    if (!written) return bench_.notices.failed(written.error());
    bench_.outputs.add(Outputs::Kind::table, file);
    bench_.notices.informOf(tr("The picks are in %1.").arg(toQt(toPath(file).filename())), file);
}

}  // namespace vestige
