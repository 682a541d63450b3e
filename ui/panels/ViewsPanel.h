#pragma once

#include <QString>

#include "ui/panels/PanelSection.h"

class QPoint;
class QTreeWidgetItem;

namespace vestige {

class ActionCatalog;
class Document;

/// The named views with their shortcuts; a click takes one. Below them the views that the case keeps: a click
/// goes to one, a double click or F2 renames it, its menu has the rest.
class ViewsPanel : public PanelSection {
    Q_OBJECT

  public:
    ViewsPanel(const ActionCatalog& actions, Document& document, QWidget* parent = nullptr);

    /// Lets the user type another name for a saved view.
    void editName(const QString& name);

  signals:
    void wanted(const QString& name);
    /// The saved view is to be what is seen now.
    void updateWanted(const QString& name);

  private:
    QWidget* makeNamed(const ActionCatalog& actions);
    QWidget* makeSaved(const ActionCatalog& actions);
    void fill();
    void rename(QTreeWidgetItem* row);
    void showMenu(const QPoint& place);

    Document& document_;
    CompactList* saved_ = nullptr;
};

}  // namespace vestige
