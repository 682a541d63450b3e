#pragma once

#include <QWidget>

namespace vestige {

class ActionCatalog;
class Document;
class LayerForm;
class Notices;
class ParameterForm;
class Selection;

/// What a registration depends on: the selected layer's properties, preprocessing, method; and the button.
class AlignPanel : public QWidget {
    Q_OBJECT

  public:
    AlignPanel(Document& document, Selection& selection, Notices& notices, const ActionCatalog& actions,
               QWidget* parent = nullptr);

  private:
    Document& document_;
    ParameterForm* preprocess_;
    ParameterForm* registration_;
};

}  // namespace vestige
