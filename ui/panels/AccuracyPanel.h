#pragma once

#include "ui/panels/PanelSection.h"

namespace vestige {

class Document;
class FiguresRow;
class ReChartView;
class Selection;

/// The relative errors as bars per object and method, and the RMSE of the method shown, with and without the
/// excluded objects, which are named.
class AccuracyPanel : public PanelSection {
    Q_OBJECT

  public:
    AccuracyPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// Without the chart, whose figures stand in the table, too.
    void setCompact(bool compact);

  private:
    void fill();

    Document& document_;
    Selection& selection_;
    ReChartView* chart_;
    FiguresRow* figures_;
    QLabel* remark_;
    QLabel* empty_;
    bool compact_ = false;
};

}  // namespace vestige
