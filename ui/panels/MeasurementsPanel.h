#pragma once

#include "ui/panels/PanelSection.h"

class QComboBox;
class QTableView;

namespace vestige {

class ActionCatalog;
class Document;
class MeasurementsModel;
class Notices;
class Selection;

/// The table of measurements with the choice of method, and the repeats of the selected object.
class MeasurementsPanel : public PanelSection {
    Q_OBJECT

  public:
    MeasurementsPanel(Document& document, Selection& selection, Notices& notices,
                      const ActionCatalog& actions, QWidget* parent = nullptr);
    /// Begins to edit the object's name in its row.
    void editName(const std::string& object);

  private:
    void makeTable();
    void fillMethods();
    void follow();
    void showVerification();
    void showMenu(const QPoint& position, const ActionCatalog& actions);

    Document& document_;
    Selection& selection_;
    MeasurementsModel* model_;
    QTableView* table_;
    QComboBox* methods_;
    QLabel* empty_;
    QLabel* repeats_;
    QLabel* verified_;  ///< what the known distances say of the method shown
    bool following_ = false;
};

}  // namespace vestige
