#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>

#include "core/registration/RegistrationQuality.h"

class QLabel;

namespace vestige {

/// The verdict of a registration for the eye: a shape and a word, and a colour besides.
QString verdictWord(Verdict verdict);
/// What it means for the layer, one sentence.
QString verdictSentence(Verdict verdict);
QColor verdictColor(Verdict verdict, const QPalette& palette);
/// Tick in a disc, exclamation mark in a triangle, cross in a square, question mark in a diamond.
QPixmap verdictPicture(Verdict verdict, int side_px, const QWidget& on);

/// Picture and word in one line, the sentence below.
class VerdictBadge : public QWidget {
    Q_OBJECT

  public:
    explicit VerdictBadge(QWidget* parent = nullptr);
    void setVerdict(Verdict verdict);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QLabel* picture_;
    QLabel* word_;
    QLabel* sentence_;
    QColor color_;
    std::optional<Verdict> verdict_;
};

}  // namespace vestige
