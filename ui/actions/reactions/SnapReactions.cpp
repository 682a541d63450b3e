#include "ui/actions/reactions/SnapReactions.h"

#include <QAction>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/PickChoices.h"

namespace vestige {
namespace {

std::string snapAction(SnapMode mode) {
    return "snap." + std::string(name(mode));
}

}  // namespace

SnapReactions::SnapReactions(ActionCatalog& actions, PickChoices& choices, QObject* parent)
    : QObject(parent), actions_(actions), choices_(choices) {
    for (const SnapMode mode : kSnapModes)
        actions_.onTriggered(snapAction(mode), [this, mode] { choices_.setSnap(mode); });
    actions_.onTriggered("snap.next", [this] { choices_.nextSnap(); });
    actions_.onToggled("pick.loupe", [this](bool on) { choices_.setLoupe(on); });
    actions_.onToggled("pick.move", [this](bool on) { choices_.setMovable(on); });
    connect(&choices_, &PickChoices::changed, this, [this] { follow(); });
    follow();
}

void SnapReactions::follow() {
    actions_[snapAction(choices_.snap())].setChecked(true);
    actions_["pick.loupe"].setChecked(choices_.loupe());
    actions_["pick.move"].setChecked(choices_.movable());
}

}  // namespace vestige
