#include "ui/actions/reactions/EditReactions.h"

#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"

namespace vestige {

EditReactions::EditReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    actions.onTriggered("edit.undo", [this] { bench_.document.undo(); });
    actions.onTriggered("edit.redo", [this] { bench_.document.redo(); });
    actions.onTriggered("layer.target",
                        [this] { bench_.document.perform(setTarget(bench_.selection.layer())); });
    actions.onTriggered("layer.remove",
                        [this] { bench_.document.perform(removeLayer(bench_.selection.layer())); });
    actions.onTriggered("object.add", [this] { addObject(); });
    actions.onTriggered("object.remove",
                        [this] { bench_.document.perform(removeMeasurement(bench_.selection.object())); });
    actions.onTriggered("object.remove-pick", [this] { removeLastPick(); });
    connect(&bench_.document, &Document::changed, this, [this] { updateTexts(); });
}

void EditReactions::updateTexts() {
    const auto& document = bench_.document;
    bench_.actions["edit.undo"].setText(document.canUndo() ? tr("&Undo %1").arg(document.undoText())
                                                           : tr("&Undo"));
    bench_.actions["edit.redo"].setText(document.canRedo() ? tr("&Redo %1").arg(document.redoText())
                                                           : tr("&Redo"));
}

void EditReactions::addObject() {
    Measurement measurement;
    measurement.object = freeObjectName(bench_.document.state());
    const std::string object = measurement.object;
    bench_.document.perform(setMeasurement(std::move(measurement), "add " + object));
    bench_.selection.setObject(object);
}

void EditReactions::removeLastPick() {
    const Measurement* measurement = bench_.document.state().measurement(bench_.selection.object());
    if (!measurement) return;
    const auto last = lastPick(*measurement, bench_.document.state(), bench_.selection.method());
    if (!last) return;
    if (last->path)
        bench_.document.perform(removePath(measurement->object, last->layer, last->repeat));
    else
        bench_.document.perform(removePick(measurement->object, last->layer, last->repeat));
}

}  // namespace vestige
