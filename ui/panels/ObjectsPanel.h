#pragma once

#include "ui/panels/PanelSection.h"

namespace vestige {

class Document;
class Selection;

/// The objects to measure and how many of three repeats each has for the method shown.
class ObjectsPanel : public PanelSection {
    Q_OBJECT

  public:
    ObjectsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

  private:
    void fill();

    Document& document_;
    Selection& selection_;
    CompactList* list_;
};

}  // namespace vestige
