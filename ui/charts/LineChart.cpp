#include "ui/charts/LineChart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace vestige {
namespace {

/// A logarithmic axis from `low` to `high` with ticks at 1, 2 and 5 times powers of ten, at 1 alone where
/// these are many.
struct LogAxis {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;

    void take(double value) {
        if (!(value > 0) || !std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool empty() const { return !(high > 0); }
    void widen(double factor) {
        low /= factor;
        high *= factor;
    }
    double share(double value) const { return std::log(value / low) / std::log(high / low); }
    std::vector<double> ticks() const {
        std::vector<double> found;
        const bool many = high / low > 300;
        for (int power = static_cast<int>(std::floor(std::log10(low))); power <= std::log10(high); ++power)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double tick = digit * std::pow(10.0, power);
                if (tick >= low && tick <= high && (digit == 1 || !many)) found.push_back(tick);
            }
        return found;
    }
};

QString tickText(double tick) {
    return QString::number(tick, 'g', 3);
}

class Painter {
  public:
    Painter(QPainter& painter, const QRectF& area, const LineChart& chart, const ChartStyle& style)
        : painter_(painter), area_(area), chart_(chart), style_(style), metrics_(style.font) {
        for (const auto& series : chart.series)
            for (const auto& [x, y] : series.points) {
                if (!(x > 0) || !(y > 0)) continue;
                x_.take(x);
                y_.take(y);
                sizes_.insert(x);
            }
    }

    void paint() {
        if (x_.empty()) return;
        x_.widen(1.12);
        y_.widen(1.3);
        painter_.save();
        painter_.setClipRect(area_);
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(style_.font);
        const double legend = paintLegend();
        placePlot(legend);
        paintAxes();
        for (std::size_t s = 0; s < chart_.series.size(); ++s) paintSeries(s);
        painter_.restore();
    }

  private:
    void placePlot(double legend) {
        const double em = metrics_.height();
        double axis = metrics_.horizontalAdvance(QString::fromStdString(chart_.yName));
        for (const double tick : y_.ticks())
            axis = std::max(axis, metrics_.horizontalAdvance(tickText(tick)));
        plot_ = area_.adjusted(axis + 0.7 * em, legend + 0.6 * em, -0.5 * em, -2.6 * em);
    }

    QPointF at(double x, double y) const {
        return {plot_.left() + x_.share(x) * plot_.width(), plot_.bottom() - y_.share(y) * plot_.height()};
    }

    void paintAxes() {
        const double em = metrics_.height();
        painter_.setPen(QPen(style_.grid, style_.line));
        for (const double tick : y_.ticks()) {
            const double y = at(x_.low, tick).y();
            painter_.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
        }
        for (const double tick : sizes_) {
            const double x = at(tick, y_.low).x();
            painter_.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
        }
        painter_.setPen(style_.text);
        for (const double tick : y_.ticks()) {
            const double y = at(x_.low, tick).y();
            painter_.drawText(QRectF(area_.left(), y - em, plot_.left() - area_.left() - 0.4 * em, 2 * em),
                              Qt::AlignRight | Qt::AlignVCenter, tickText(tick));
        }
        for (const double tick : sizes_)
            painter_.drawText(QRectF(at(tick, y_.low).x() - 3 * em, plot_.bottom() + 0.2 * em, 6 * em, em),
                              Qt::AlignHCenter | Qt::AlignVCenter, tickText(tick));
        painter_.setPen(style_.muted);
        painter_.drawText(QRectF(plot_.left(), plot_.bottom() + 1.3 * em, plot_.width(), em),
                          Qt::AlignHCenter | Qt::AlignVCenter, QString::fromStdString(chart_.xName));
        painter_.drawText(
            QRectF(area_.left(), plot_.bottom() + 0.2 * em, plot_.left() - area_.left() - 0.4 * em, em),
            Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(chart_.yName));
    }

    void paintSeries(std::size_t s) {
        const auto& series = chart_.series[s];
        QPolygonF line;
        for (const auto& [x, y] : series.points)
            if (x > 0 && y > 0) line << at(x, y);
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(penOf(s));
        painter_.drawPolyline(line);
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(colorOf(s));
        const double radius = (series.dashed ? 1.5 : 2.4) * style_.line;
        for (const QPointF& point : line) painter_.drawEllipse(point, radius, radius);
        painter_.setBrush(Qt::NoBrush);
    }

    /// Height of the legend, whose entries wrap.
    double paintLegend() {
        const double em = metrics_.height();
        double x = area_.left(), y = area_.top();
        for (std::size_t s = 0; s < chart_.series.size(); ++s) {
            const QString name = QString::fromStdString(chart_.series[s].name);
            const double width = metrics_.horizontalAdvance(name) + 3.4 * em;
            if (x > area_.left() && x + width > area_.right()) {
                x = area_.left();
                y += 1.15 * em;
            }
            painter_.setPen(penOf(s));
            painter_.drawLine(QPointF(x, y + 0.5 * em), QPointF(x + 1.6 * em, y + 0.5 * em));
            painter_.setPen(style_.text);
            painter_.drawText(QRectF(x + 2 * em, y, width, em), Qt::AlignLeft | Qt::AlignVCenter, name);
            x += width;
        }
        return y + em - area_.top();
    }

    /// A published series has the colour of the measured one of the same place among its kind.
    QColor colorOf(std::size_t s) const {
        if (style_.series.empty()) return style_.text;
        std::size_t place = 0;
        for (std::size_t i = 0; i < s; ++i)
            if (chart_.series[i].dashed == chart_.series[s].dashed) ++place;
        return style_.series[place % style_.series.size()];
    }
    QPen penOf(std::size_t s) const {
        const bool dashed = chart_.series[s].dashed;
        return QPen(colorOf(s), (dashed ? 0.9 : 1.6) * style_.line, dashed ? Qt::DashLine : Qt::SolidLine,
                    Qt::RoundCap, Qt::RoundJoin);
    }

    QPainter& painter_;
    QRectF area_;
    const LineChart& chart_;
    const ChartStyle& style_;
    QFontMetricsF metrics_;
    LogAxis x_;
    std::set<double> sizes_;  ///< the x that occur, marked on the axis
    LogAxis y_;
    QRectF plot_;
};

}  // namespace

void paintLineChart(QPainter& painter, const QRectF& area, const LineChart& chart, const ChartStyle& style) {
    Painter(painter, area, chart, style).paint();
}

}  // namespace vestige
