#pragma once

#include "ui/panels/PanelSection.h"

namespace vestige {

class ActionCatalog;

/// The named views with their shortcuts; a click takes one.
class ViewsPanel : public PanelSection {
    Q_OBJECT

  public:
    explicit ViewsPanel(const ActionCatalog& actions, QWidget* parent = nullptr);
};

}  // namespace vestige
