#include "ui/actions/ActionCatalog.h"

#include <QAction>
#include <QActionGroup>
#include <QIcon>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>

#include "ui/actions/ActionText.h"
#include "ui/actions/Icons.h"
#include "ui/document/Wording.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {
ActionCatalog::ActionCatalog(QWidget* window) : QObject(window) {
    std::map<std::string, QActionGroup*> groups;
    for (const ActionSpec& spec : actionTable()) {
        auto* action = new QAction(said(spec.text), window);
        action->setObjectName(spec.id);
        action->setIconText(withoutMnemonic(action->text()));
        action->setShortcut(QKeySequence::fromString(spec.shortcut, QKeySequence::PortableText));
        action->setCheckable(spec.checkable);
        action->setStatusTip(said(spec.help));
        if (*spec.group) {
            QActionGroup*& group = groups[spec.group];
            if (!group) group = new QActionGroup(this);
            group->addAction(action);
        }
        window->addAction(action);
        actions_[spec.id] = action;
        tip(spec);
    }
}

void ActionCatalog::tip(const ActionSpec& spec) {
    QAction& action = *actions_.at(spec.id);
    QString tip = withoutMnemonic(action.text());
    if (!action.shortcut().isEmpty())
        tip += "  (" + action.shortcut().toString(QKeySequence::NativeText) + ")";
    action.setToolTip(tip + "\n" + action.statusTip());
}

int ActionCatalog::reactionsOf(const std::string& id) const {
    const auto found = reactions_.find(id);
    return found == reactions_.end() ? 0 : found->second;
}

void ActionCatalog::setShortcut(const std::string& id, const QKeySequence& keys) {
    (*this)[id].setShortcut(keys);
    for (const ActionSpec& spec : actionTable())
        if (id == spec.id) tip(spec);
}

QAction& ActionCatalog::operator[](const std::string& id) const {
    return *actions_.at(id);
}

QString ActionCatalog::text(const ActionSpec& spec) const {
    return said(spec.text);
}

QString ActionCatalog::menuText(const ActionSpec& spec) const {
    return said(spec.menu);
}

void ActionCatalog::onTriggered(const std::string& id, std::function<void()> reaction) {
    int& ran = reactions_[id];
    connect(&(*this)[id], &QAction::triggered, this,
            [name = QString::fromStdString(id), reaction = std::move(reaction), &ran] {
                const WatchedTime watched("action", name);
                ++ran;
                reaction();
            });
}

void ActionCatalog::onToggled(const std::string& id, std::function<void(bool)> reaction) {
    int& ran = reactions_[id];
    connect(&(*this)[id], &QAction::toggled, this,
            [name = QString::fromStdString(id), reaction = std::move(reaction), &ran](bool checked) {
                const WatchedTime watched("action", name);
                ++ran;
                reaction(checked);
            });
}

void ActionCatalog::update(const Situation& situation) {
    for (const ActionSpec& spec : actionTable()) (*this)[spec.id].setEnabled(spec.enabled(situation));
}

void ActionCatalog::paintIcons(const QPalette& palette) {
    for (const ActionSpec& spec : actionTable())
        if (*spec.icon) (*this)[spec.id].setIcon(iconOn(palette, spec.icon));
}

void ActionCatalog::fill(QMenuBar& bar) const {
    QMenu* menu = nullptr;
    QString name;
    for (const ActionSpec& spec : actionTable()) {
        if (!menu || name != spec.menu) {
            name = spec.menu;
            menu = bar.addMenu(said(spec.menu));
            menu->setObjectName(withoutMnemonic(name).toLower());
            menu->setToolTipsVisible(false);
        }
        if (spec.separatorBefore) menu->addSeparator();
        menu->addAction(&(*this)[spec.id]);
    }
}

}  // namespace vestige
