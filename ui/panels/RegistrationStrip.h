#pragma once

#include <QWidget>

class QLabel;

namespace vestige {

class Attempts;
class Document;
class FiguresRow;
class Selection;

/// Under the view: the verdict and the figures of the registration that is described (shownFit).
class RegistrationStrip : public QWidget {
    Q_OBJECT

  public:
    RegistrationStrip(Document& document, Selection& selection, Attempts& attempts,
                      QWidget* parent = nullptr);

  private:
    void fill();

    Document& document_;
    Selection& selection_;
    Attempts& attempts_;
    QLabel* picture_;
    FiguresRow* figures_;
    QLabel* empty_;
};

}  // namespace vestige
