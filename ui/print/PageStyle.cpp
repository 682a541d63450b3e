#include "ui/print/PageStyle.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Translation.h"

namespace vestige {
namespace {

bool isChinese() {
    return language() == Language::simplifiedChinese;
}

QString chooseFamily() {
    // WenQuanYi Micro Hei for Chinese: of Noto Sans CJK the writer embeds figures without their characters,
    // so that no number could be searched or copied. Not Inter, which the windows use: its contextual
    // alternates put glyphs into the file that have no character, so that brackets, hyphens and colons cannot
    // be searched or copied.
    const QStringList families = QFontDatabase().families();
    if (isChinese() && families.contains(QStringLiteral("WenQuanYi Micro Hei")))
        return QStringLiteral("WenQuanYi Micro Hei");
    for (const char* family : {"Liberation Sans", "DejaVu Sans"})
        if (families.contains(QString::fromLatin1(family))) return QString::fromLatin1(family);
    return QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
}

double digitWidth(const QFontMetricsF& metrics) {
    double widest = 0;
    for (char digit = '0'; digit <= '9'; ++digit)
        widest = std::max(widest, metrics.horizontalAdvance(QLatin1Char(digit)));
    return widest;
}

}  // namespace

PageStyle::PageStyle() : family(chooseFamily()) {}

QFont PageStyle::font(double points, int weight, bool italic) const {
    QFont font(family);
    font.setPixelSize(static_cast<int>(std::lround(dotsFromPoints(points))));
    // It has one weight; only what is as bold as Bold is drawn bolder.
    font.setWeight(isChinese() && weight > QFont::Medium ? QFont::Bold : weight);
    font.setItalic(italic);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

QStringList wrapText(const QString& text, const QFont& font, double width) {
    QStringList lines;
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        QTextLayout layout(paragraph, font);
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout.setTextOption(option);
        layout.beginLayout();
        const int before = lines.size();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(width);
            lines << paragraph.mid(line.textStart(), line.textLength()).trimmed();
        }
        layout.endLayout();
        if (lines.size() == before) lines << QString();
    }
    return lines;
}

double figuresWidth(const QFont& font, const QString& text) {
    const QFontMetricsF metrics(font);
    const double digit = digitWidth(metrics);
    double width = 0;
    for (const QChar c : text)
        width += c >= QLatin1Char('0') && c <= QLatin1Char('9') ? digit : metrics.horizontalAdvance(c);
    return width;
}

void drawFigures(QPainter& painter, const QFont& font, double x, double baseline, const QString& text,
                 bool right) {
    const QFontMetricsF metrics(font);
    const double digit = digitWidth(metrics);
    painter.setFont(font);
    double at = right ? x - figuresWidth(font, text) : x;
    for (const QChar c : text) {
        const double natural = metrics.horizontalAdvance(c);
        const double advance = c >= QLatin1Char('0') && c <= QLatin1Char('9') ? digit : natural;
        painter.drawText(QPointF(at + (advance - natural) / 2, baseline), QString(c));
        at += advance;
    }
}

}  // namespace vestige
