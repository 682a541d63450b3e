#pragma once

#include <QAbstractButton>

#include "ui/document/Steps.h"

namespace vestige {

/// One step of the bar: its number, or a check once it is done, its name, and in a few words what is missing.
class StepButton : public QAbstractButton {
    Q_OBJECT

  public:
    explicit StepButton(WayStep step, QWidget* parent = nullptr);
    void setFacts(const StepFacts& facts);
    /// The step whose panel is shown.
    void setShown(bool shown);
    bool isShown() const { return shown_; }

    QSize sizeHint() const override;
    /// Without the words, which give way first.
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    QString words() const;
    int wordsLeft() const;
    void paintBadge(QPainter& painter) const;

    StepFacts facts_;
    bool shown_ = false;
};

}  // namespace vestige
