#include "ui/charts/DiagramChart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>

namespace vestige {
namespace {

struct EvenAxis {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;

    void take(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool empty() const { return !(high >= low); }
    /// A little room; a flat line gets a span of its own.
    void widen(double share) {
        const double room = high > low ? share * (high - low) : std::max(0.05, 0.01 * std::abs(high));
        low -= room;
        high += room;
    }
    double share(double value) const { return (value - low) / (high - low); }
    double step(int wanted) const {
        const double rough = (high - low) / wanted;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        for (const double digit : {1.0, 2.0, 5.0})
            if (digit * power >= rough) return digit * power;
        return 10 * power;
    }
    std::vector<double> ticks(int wanted) const {
        std::vector<double> found;
        const double each = step(wanted);
        for (double k = std::ceil(low / each); k * each <= high; ++k) found.push_back(k * each);
        return found;
    }
};

QString tickText(double tick, double step) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    QString text = QString::number(std::abs(tick) < 1e-9 * step ? 0.0 : tick, 'f', decimals);
    return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

class Painter {
  public:
    Painter(QPainter& painter, const QRectF& area, const Diagram& diagram, const ChartStyle& style)
        : painter_(painter), area_(area), diagram_(diagram), style_(style), metrics_(style.font) {
        for (const auto& series : diagram.series)
            for (const auto& [x, y] : series.points) {
                x_.take(x);
                y_.take(y);
            }
    }

    void paint() {
        if (x_.empty() || y_.empty()) return;
        x_.widen(0.02);
        y_.widen(0.12);
        painter_.save();
        painter_.setClipRect(area_);
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(style_.font);
        const double em = metrics_.height();
        const double legend = diagram_.series.size() > 1 ? paintLegend() : 0;
        double axis = metrics_.horizontalAdvance(QString::fromStdString(diagram_.yName));
        for (const double tick : y_.ticks(kRows))
            axis = std::max(axis, metrics_.horizontalAdvance(tickText(tick, y_.step(kRows))));
        plot_ = area_.adjusted(axis + 0.7 * em, legend + 0.6 * em, -0.5 * em, -2.6 * em);
        paintAxes();
        for (std::size_t s = 0; s < diagram_.series.size(); ++s) paintSeries(s);
        painter_.restore();
    }

  private:
    static constexpr int kRows = 5;
    static constexpr int kColumns = 9;

    QPointF at(double x, double y) const {
        return {plot_.left() + x_.share(x) * plot_.width(), plot_.bottom() - y_.share(y) * plot_.height()};
    }

    void paintAxes() {
        const double em = metrics_.height();
        for (const double tick : y_.ticks(kRows)) {
            const double y = at(x_.low, tick).y();
            painter_.setPen(QPen(style_.grid, style_.line));
            painter_.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
            painter_.setPen(style_.text);
            painter_.drawText(QRectF(area_.left(), y - em, plot_.left() - area_.left() - 0.4 * em, 2 * em),
                              Qt::AlignRight | Qt::AlignVCenter, tickText(tick, y_.step(kRows)));
        }
        for (const double tick : x_.ticks(kColumns)) {
            const double x = at(tick, y_.low).x();
            painter_.setPen(QPen(style_.grid, style_.line));
            painter_.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
            painter_.setPen(style_.text);
            painter_.drawText(QRectF(x - 3 * em, plot_.bottom() + 0.2 * em, 6 * em, em),
                              Qt::AlignHCenter | Qt::AlignVCenter, tickText(tick, x_.step(kColumns)));
        }
        painter_.setPen(style_.muted);
        painter_.drawText(QRectF(plot_.left(), plot_.bottom() + 1.3 * em, plot_.width(), em),
                          Qt::AlignHCenter | Qt::AlignVCenter, QString::fromStdString(diagram_.xName));
        painter_.drawText(
            QRectF(area_.left(), plot_.bottom() + 0.2 * em, plot_.left() - area_.left() - 0.4 * em, em),
            Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(diagram_.yName));
    }

    void paintSeries(std::size_t s) {
        const auto& series = diagram_.series[s];
        QPolygonF line;
        for (const auto& [x, y] : series.points)
            if (std::isfinite(x) && std::isfinite(y)) line << at(x, y);
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(penOf(s));
        painter_.drawPolyline(line);
        if (!series.dots) return;
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(penOf(s).color());
        for (const QPointF& point : line) painter_.drawEllipse(point, 2.4 * style_.line, 2.4 * style_.line);
        painter_.setBrush(Qt::NoBrush);
    }

    /// Height of the legend.
    double paintLegend() {
        const double em = metrics_.height();
        double x = area_.left();
        for (std::size_t s = 0; s < diagram_.series.size(); ++s) {
            const QString name = QString::fromStdString(diagram_.series[s].name);
            const double y = area_.top();
            painter_.setPen(penOf(s));
            painter_.drawLine(QPointF(x, y + 0.5 * em), QPointF(x + 1.6 * em, y + 0.5 * em));
            painter_.setPen(style_.text);
            const double width = metrics_.horizontalAdvance(name) + 3.4 * em;
            painter_.drawText(QRectF(x + 2 * em, y, width, em), Qt::AlignLeft | Qt::AlignVCenter, name);
            x += width;
        }
        return em;
    }

    QPen penOf(std::size_t s) const {
        const QColor color = style_.series.empty() ? style_.text : style_.series[s % style_.series.size()];
        return QPen(color, 1.6 * style_.line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    }

    QPainter& painter_;
    QRectF area_;
    const Diagram& diagram_;
    const ChartStyle& style_;
    QFontMetricsF metrics_;
    EvenAxis x_;
    EvenAxis y_;
    QRectF plot_;
};

}  // namespace

void paintDiagram(QPainter& painter, const QRectF& area, const Diagram& diagram, const ChartStyle& style) {
    Painter(painter, area, diagram, style).paint();
}

}  // namespace vestige
