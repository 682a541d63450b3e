#pragma once

#include <QWidget>

#include "ui/document/Steps.h"

class QLabel;
class QTreeWidget;

namespace vestige {

class ActionCatalog;
class CompactList;
class Document;
class Notices;
class Outputs;
class StepsList;

/// The last step: the case's details, what is missing, what a report writes, and what was written.
class ReportPanel : public QWidget {
    Q_OBJECT

  public:
    ReportPanel(Document& document, Notices& notices, Outputs& outputs, const ActionCatalog& actions,
                QWidget* parent = nullptr);

  signals:
    /// Something is missing in that step, and the user goes there.
    void stepWanted(vestige::WayStep step);

  private:
    void follow();
    void fillOutputs();

    Document& document_;
    Outputs& outputs_;
    StepsList* missing_;
    CompactList* written_;
};

}  // namespace vestige
