#pragma once

#include <QObject>

namespace vestige {

class ActionCatalog;
class PickChoices;

/// What a pick snaps to, the loupe, and whether picks can be moved. Actions and PickChoices follow each
/// other.
class SnapReactions : public QObject {
    Q_OBJECT

  public:
    SnapReactions(ActionCatalog& actions, PickChoices& choices, QObject* parent = nullptr);

  private:
    void follow();

    ActionCatalog& actions_;
    PickChoices& choices_;
};

}  // namespace vestige
