#include "ui/actions/reactions/KindReactions.h"

#include <QAction>

#include "core/scene/KindEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Selection.h"

namespace vestige {

KindReactions::KindReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    bench_.actions.onTriggered("measure.check",
                               [this] { setChecked(bench_.actions["measure.check"].isChecked()); });
    connect(&bench_.document, &Document::changed, this, [this] { follow(); });
    connect(&bench_.selection, &Selection::changed, this, [this] { follow(); });
    follow();
}

void KindReactions::setChecked(bool on) {
    const Measurement* object = bench_.document.state().measurement(bench_.selection.object());
    if (object) {
        bench_.document.perform(
            setCheck(object->object, on ? std::optional(kUsualTolerance_m) : std::nullopt));
        if (on && !object->tape_m)
            bench_.notices.inform(
                tr("Type the known distance into the tape column of \"%1\"; its tolerance stands below the "
                   "table.")
                    .arg(QString::fromStdString(object->object)));
    }
    follow();
}

void KindReactions::follow() {
    const Measurement* object = bench_.document.state().measurement(bench_.selection.object());
    bench_.actions["measure.check"].setChecked(object && object->checkTolerance_m);
}

}  // namespace vestige
