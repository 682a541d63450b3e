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
    void onTriggered(const std::string& id, std::function<void()> reaction);
    void onToggled(const std::string& id, std::function<void(bool)> reaction);

    /// Enables and disables every action.
    void update(const Situation& situation);
    /// Draws the icons in the colours of that palette.
    void paintIcons(const QPalette& palette);
    /// One menu per menu name of the table, in its order.
    void fill(QMenuBar& bar) const;

  private:
    std::map<std::string, QAction*> actions_;
};

}  // namespace vestige
