#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>
#include <QStringList>

class QPainter;

namespace vestige {

/// Everything on a page is in dots of 1/1200 inch, fine enough for whole-pixel fonts.
constexpr int kDotsPerInch = 1200;
constexpr double dotsFromMm(double mm) {
    return mm * kDotsPerInch / 25.4;
}
constexpr double dotsFromPoints(double points) {
    return points * kDotsPerInch / 72;
}

/// Paper, fonts and colours of a report; every colour is opaque, as PDF/A-1b asks.
struct PageStyle {
    double width = dotsFromMm(210);
    double height = dotsFromMm(297);
    double left = dotsFromMm(22);
    double right = dotsFromMm(20);
    double top = dotsFromMm(27);
    double bottom = dotsFromMm(24);

    QString family;  ///< Liberation Sans, else DejaVu Sans, else what the system has; of Chinese WenQuanYi
                     ///< Micro Hei
    QColor text{0x1b, 0x22, 0x2c};
    QColor muted{0x5b, 0x66, 0x73};
    QColor accent{0x1b, 0x3a, 0x5c};
    QColor rule{0xc3, 0xca, 0xd2};
    QColor headRow{0xee, 0xf1, 0xf5};
    QColor emphasis{0xfb, 0xf1, 0xdf};

    PageStyle();
    double textWidth() const { return width - left - right; }
    QFont font(double points, int weight = QFont::Normal, bool italic = false) const;
};

/// `text` broken into lines no wider than `width`, at words, else anywhere; line feeds end a line. At least
/// one line.
QStringList wrapText(const QString& text, const QFont& font, double width);

/// Draws one line with all digits equally wide, so that columns of figures align; `right` puts its end
/// there, else it begins at `x`.
void drawFigures(QPainter& painter, const QFont& font, double x, double baseline, const QString& text,
                 bool right);
double figuresWidth(const QFont& font, const QString& text);

}  // namespace vestige
