#pragma once

#include <QWidget>

class QLineEdit;

namespace vestige {

class Document;
class Notices;

/// The case's name, operator and place; each field that is left is one step of the history.
class CaseForm : public QWidget {
    Q_OBJECT

  public:
    CaseForm(Document& document, Notices& notices, QWidget* parent = nullptr);

  private:
    void enter();
    void fill();

    Document& document_;
    Notices& notices_;
    QLineEdit* name_;
    QLineEdit* operator_;
    QLineEdit* latitude_;
    QLineEdit* longitude_;
    QLineEdit* height_;
};

}  // namespace vestige
