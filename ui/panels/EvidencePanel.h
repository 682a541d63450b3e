#pragma once

#include "ui/panels/PanelSection.h"

namespace vestige {

class Document;
class Evidence;

/// The files of the case and whether they are still what was read.
class EvidencePanel : public PanelSection {
    Q_OBJECT

  public:
    EvidencePanel(Document& document, Evidence& evidence, QWidget* parent = nullptr);

  private:
    void fill();

    Document& document_;
    Evidence& evidence_;
    CompactList* list_;
};

}  // namespace vestige
