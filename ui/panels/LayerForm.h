#pragma once

#include <QWidget>

#include "core/scene/Layer.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace vestige {

class Document;
class Selection;

/// Name, role, unit and first pose of the selected layer; every change is an edit.
class LayerForm : public QWidget {
    Q_OBJECT

  public:
    LayerForm(Document& document, Selection& selection, QWidget* parent = nullptr);

  private:
    void fill();
    void change(const QString& what, const std::function<void(Layer&)>& change);

    Document& document_;
    Selection& selection_;
    QLabel* empty_;
    QWidget* fields_;
    QLineEdit* name_;
    QComboBox* role_;
    QComboBox* unit_;
    QComboBox* start_;
};

}  // namespace vestige
