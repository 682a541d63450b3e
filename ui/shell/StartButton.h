#pragma once

#include <QAbstractButton>

class QAction;

namespace vestige {

/// A large button of the start page: the action's icon, a title and a sentence.
class StartButton : public QAbstractButton {
    Q_OBJECT

  public:
    StartButton(QAction& action, const QString& title, const QString& sentence, bool primary,
                QWidget* parent = nullptr);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    QAction& action_;
    QString sentence_;
    bool primary_;
};

}  // namespace vestige
