#pragma once

#include <QWidget>

class QFormLayout;

namespace vestige {

class ActionCatalog;
class Document;
class Selection;

/// The first step: add files, and see what the selected one is.
class ImportPanel : public QWidget {
    Q_OBJECT

  public:
    ImportPanel(Document& document, Selection& selection, const ActionCatalog& actions,
                QWidget* parent = nullptr);

  private:
    void fill();

    Document& document_;
    Selection& selection_;
    QWidget* file_ = nullptr;  ///< hidden while no layer is selected
    QWidget* facts_;
    QFormLayout* form_;
};

}  // namespace vestige
