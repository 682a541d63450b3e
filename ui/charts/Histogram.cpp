#include "ui/charts/Histogram.h"

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

/// 1, 2 or 5 times a power of ten, at most `value`.
double roundedDown(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {5.0, 2.0})
        if (step * power <= value * (1 + 1e-9)) return step * power;
    return power;
}

QString tickText(double value, double step) {
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    const QString digits = QString::number(std::abs(value), 'f', decimals);
    return value == 0  ? QStringLiteral("0")
           : value < 0 ? QChar(0x2212) + digits
                       : QStringLiteral("+") + digits;
}

}  // namespace

void paintHistogram(QPainter& painter, const QRectF& area, const Histogram& histogram,
                    const ChartStyle& style) {
    if (histogram.counts.empty() || !(histogram.width > 0)) return;
    painter.save();
    painter.setClipRect(area);
    painter.setFont(style.font);
    const QFontMetricsF metrics(style.font);
    const double em = metrics.height();
    const QRectF plot = area.adjusted(1.5 * em, em * 1.2, -1.5 * em, -2.4 * em);
    const auto bars = static_cast<double>(histogram.counts.size());
    const double most =
        static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
    const double bar = plot.width() / bars;
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        const double height = most > 0 ? plot.height() * static_cast<double>(histogram.counts[i]) / most : 0;
        painter.fillRect(QRectF(plot.left() + bar * static_cast<double>(i), plot.bottom() - height,
                                std::max(1.0, bar - 1), height),
                         style.series.empty() ? style.text : style.series[0]);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(style.muted, style.line));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    painter.setPen(QPen(style.text, style.line, Qt::DashLine));
    painter.drawLine(QPointF(plot.center().x(), plot.top()), QPointF(plot.center().x(), plot.bottom()));
    const double reach = 0.5 * bars * histogram.width;
    const double step = roundedDown(reach / 2);
    painter.setPen(style.muted);
    for (int k = -static_cast<int>(reach / step + 1e-9); k * step <= reach * (1 + 1e-9); ++k) {
        const double at = plot.center().x() + 0.5 * plot.width() * k * step / reach;
        painter.drawLine(QPointF(at, plot.bottom()), QPointF(at, plot.bottom() + 3));
        painter.drawText(QRectF(at - 3 * em, plot.bottom() + 3, 6 * em, em), Qt::AlignCenter,
                         tickText(k * step, step));
    }
    painter.drawText(QRectF(area.left(), plot.bottom() + 3 + em, area.width(), em),
                     Qt::AlignHCenter | Qt::AlignVCenter,
                     QObject::tr("distance to the target's surface, %1").arg(histogram.unit));
    if (histogram.outside > 0)
        painter.drawText(QRectF(area.left(), area.top(), area.width(), em), Qt::AlignRight | Qt::AlignVCenter,
                         QObject::tr("%1 points further off").arg(histogram.outside));
    painter.restore();
}

}  // namespace vestige
