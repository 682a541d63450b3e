#pragma once

#include <QToolButton>

namespace vestige {

class ActionCatalog;

/// Over the view while a tool picks: what its picks snap to, and the menu to choose it from.
class SnapButton : public QToolButton {
    Q_OBJECT

  public:
    explicit SnapButton(const ActionCatalog& actions, QWidget* parent = nullptr);

  private:
    void follow();

    const ActionCatalog& actions_;
};

}  // namespace vestige
