#include "ui/shell/SnapButton.h"

#include <QAction>
#include <QMenu>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/PickChoices.h"

namespace vestige {
namespace {

std::string snapAction(SnapMode mode) {
    return "snap." + std::string(name(mode));
}

}  // namespace

SnapButton::SnapButton(const ActionCatalog& actions, QWidget* parent)
    : QToolButton(parent), actions_(actions) {
    setObjectName("snap");
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFocusPolicy(Qt::TabFocus);
    setToolTip(tr("What a pick is taken on (N for the next)"));
    auto* menu = new QMenu(this);
    for (const SnapMode mode : kSnapModes) {
        QAction& action = actions_[snapAction(mode)];
        menu->addAction(&action);
        connect(&action, &QAction::changed, this, &SnapButton::follow);
    }
    menu->addSeparator();
    for (const char* id : {"snap.next", "pick.move", "pick.loupe"}) menu->addAction(&actions_[id]);
    setMenu(menu);
    follow();
}

void SnapButton::follow() {
    for (const SnapMode mode : kSnapModes) {
        const QAction& action = actions_[snapAction(mode)];
        if (!action.isChecked()) continue;
        setIcon(action.icon());
        setText(tr("Snap: %1").arg(snapText(mode)));
    }
    setAccessibleName(text());
}

}  // namespace vestige
