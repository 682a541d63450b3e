#pragma once

#include <QWidget>

class QLabel;

namespace vestige {

class Document;
class FiguresRow;
class Selection;

/// Under the view: how well the selected layer (else the one registered last in the list) is registered.
class RegistrationStrip : public QWidget {
    Q_OBJECT

  public:
    RegistrationStrip(Document& document, Selection& selection, QWidget* parent = nullptr);

  private:
    void fill();

    Document& document_;
    Selection& selection_;
    FiguresRow* figures_;
    QLabel* empty_;
};

}  // namespace vestige
