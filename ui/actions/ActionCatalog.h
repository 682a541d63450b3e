#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <string>

class QAction;
class QIcon;
class QMenuBar;
class QPalette;

#include "ui/actions/ActionSpec.h"

namespace vestige {

/// The QActions of the action table, by id.
class ActionCatalog : public QObject {
    Q_OBJECT

  public:
    /// Actions belong to `window`, so that shortcuts work anywhere in it.
    explicit ActionCatalog(QWidget* window);

    /// The action of the table; asking for an id it does not have is a programming error and ends the
    /// program.
    QAction& operator[](const std::string& id) const;
    bool has(const std::string& id) const { return actions_.contains(id); }
    /// The words of the table, with mnemonic, whatever the action says at present.
    QString text(const ActionSpec& spec) const;
    QString menuText(const ActionSpec& spec) const;

    void onTriggered(const std::string& id, std::function<void()> reaction);
    void onToggled(const std::string& id, std::function<void(bool)> reaction);

    /// Whether something happens when the action is triggered.
    bool hasReaction(const std::string& id) const { return reactions_.contains(id); }
    /// How often its reactions have run.
    int reactionsOf(const std::string& id) const;

    /// Changes the action's shortcut; an empty one takes it away. Tool tips follow.
    void setShortcut(const std::string& id, const QKeySequence& keys);

    /// Enables and disables every action.
    void update(const Situation& situation);
    /// Draws the icons in the colours of that palette.
    void paintIcons(const QPalette& palette);
    /// One menu per menu name of the table, in its order.
    void fill(QMenuBar& bar) const;

  private:
    void tip(const ActionSpec& spec);

    std::map<std::string, QAction*> actions_;
    std::map<std::string, int> reactions_;  ///< how often they ran, by id
};

}  // namespace vestige
