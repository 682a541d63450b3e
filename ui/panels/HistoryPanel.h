#pragma once

#include "ui/panels/PanelSection.h"

class QListWidget;

namespace vestige {

class ActionCatalog;
class History;

/// The steps of the case in words, the present one marked, the undone ones grey behind it. A click, or
/// Return, goes there.
class HistoryPanel : public PanelSection {
    Q_OBJECT

  public:
    HistoryPanel(History& history, const ActionCatalog& actions, QWidget* parent = nullptr);

  private:
    void fill();

    History& history_;
    QListWidget* list_;
};

}  // namespace vestige
