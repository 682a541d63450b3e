#pragma once

#include "core/measurement/MeasurementKind.h"
#include "ui/panels/PanelSection.h"

class QComboBox;
class QLineEdit;

namespace vestige {

class ActionCatalog;
class Document;
class FiguresTree;
class Notices;
class ParameterForm;
class Selection;

/// The selected object: its kind, the kind's own parameters, whether it is a known distance and how far it
/// may be off, and every figure with its budget to unfold.
class BudgetPanel : public PanelSection {
    Q_OBJECT

  public:
    BudgetPanel(Document& document, Selection& selection, Notices& notices, const ActionCatalog& actions,
                QWidget* parent = nullptr);

  private:
    void makeHead(const ActionCatalog& actions);
    void paintIcons();
    void fill();
    void fillSettings();
    void takeTolerance();

    Document& document_;
    Selection& selection_;
    Notices& notices_;
    QComboBox* kinds_;
    QWidget* check_;
    QLineEdit* tolerance_;
    QWidget* settings_;  ///< holds form_
    ParameterForm* form_ = nullptr;
    MeasurementKind formKind_ = MeasurementKind::distance;
    FiguresTree* tree_;
    QLabel* note_;
    QLabel* empty_;
};

}  // namespace vestige
