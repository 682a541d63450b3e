#include "ui/actions/ActionCatalog.h"

#include <QAction>
#include <QActionGroup>
#include <QIcon>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>

#include "ui/actions/Icons.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {
namespace {

QString withoutMnemonic(QString text) {
    return text.remove('&').remove(QChar(0x2026));
}

}  // namespace

ActionCatalog::ActionCatalog(QWidget* window) : QObject(window) {
    std::map<std::string, QActionGroup*> groups;
    for (const ActionSpec& spec : actionTable()) {
        auto* action = new QAction(QString::fromUtf8(spec.text), window);
        action->setObjectName(spec.id);
        action->setShortcut(QKeySequence::fromString(spec.shortcut, QKeySequence::PortableText));
        action->setCheckable(spec.checkable);
        action->setStatusTip(QString::fromUtf8(spec.help));
        QString tip = withoutMnemonic(action->text());
        if (*spec.shortcut) tip += "  (" + action->shortcut().toString(QKeySequence::NativeText) + ")";
        action->setToolTip(tip + "\n" + QString::fromUtf8(spec.help));
        if (*spec.group) {
            QActionGroup*& group = groups[spec.group];
            if (!group) group = new QActionGroup(this);
            group->addAction(action);
        }
        window->addAction(action);
        actions_[spec.id] = action;
    }
}

QAction& ActionCatalog::operator[](const std::string& id) const {
    return *actions_.at(id);
}

void ActionCatalog::onTriggered(const std::string& id, std::function<void()> reaction) {
    connect(&(*this)[id], &QAction::triggered, this,
            [name = QString::fromStdString(id), reaction = std::move(reaction)] {
                const WatchedTime watched("action", name);
                reaction();
            });
}

void ActionCatalog::onToggled(const std::string& id, std::function<void(bool)> reaction) {
    connect(&(*this)[id], &QAction::toggled, this,
            [name = QString::fromStdString(id), reaction = std::move(reaction)](bool checked) {
                const WatchedTime watched("action", name);
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
            menu = bar.addMenu(name);
            menu->setObjectName(withoutMnemonic(name).toLower());
            menu->setToolTipsVisible(false);
        }
        if (spec.separatorBefore) menu->addSeparator();
        menu->addAction(&(*this)[spec.id]);
    }
}

}  // namespace vestige
