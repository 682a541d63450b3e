#pragma once

#include <string>

#include "ui/panels/PanelSection.h"

class QTreeWidgetItem;

namespace vestige {

class ActionCatalog;
class Document;
class PointSelection;

/// The objects that were separated in the clouds: shown or hidden, name, size of the upright box. A double
/// click or F2 renames, the menu changes the kind; buttons select the points, look at them, forget the
/// object.
class PartsPanel : public PanelSection {
    Q_OBJECT

  public:
    PartsPanel(Document& document, PointSelection& points, const ActionCatalog& actions,
               QWidget* parent = nullptr);
    void editName(const std::string& name);

  private:
    void fill();
    void take(QTreeWidgetItem* row, int column);
    void showMenu(const QPoint& place);

    Document& document_;
    PointSelection& points_;
    const ActionCatalog& actions_;
    CompactList* list_;
    QWidget* buttons_;
    bool filling_ = false;
};

}  // namespace vestige
