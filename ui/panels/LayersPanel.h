#pragma once

#include "ui/panels/PanelSection.h"

namespace vestige {

class Document;
class Selection;
struct Layer;

/// The layers of the case: shown or hidden, tint, name, number of points; what the selected one is below.
class LayersPanel : public PanelSection {
    Q_OBJECT

  public:
    LayersPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

  private:
    void fill();
    void describeSelected();

    Document& document_;
    Selection& selection_;
    CompactList* list_;
    QLabel* details_;
    bool filling_ = false;
};

/// "Handheld, mm, PLY, registered": one line about a layer.
QString layerSummary(const Layer& layer, bool isTarget);

}  // namespace vestige
