#include "ui/charts/FitChart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/Numbers.h"

namespace vestige {
namespace {

/// Where the two plots lie in the area.
struct Places {
    QRectF score;
    QRectF sizes;
};

Places placesIn(const QRectF& area, const ChartStyle& style) {
    const double em = QFontMetricsF(style.font).height();
    const double left = area.left() + 3.4 * em;
    const double right = area.right() - 0.6 * em;
    const double top = area.top() + 2.4 * em;
    const double bottom = area.bottom() - 1.4 * em;
    const double between = 2.2 * em;
    const double height = std::max(1.0, 0.4 * (bottom - top - between));
    return {{left, top, right - left, height},
            {left, top + height + between, right - left, std::max(1.0, bottom - top - height - between)}};
}

double xOf(const QRectF& plot, std::size_t count, std::size_t index) {
    const double last = std::max<double>(1, static_cast<double>(count) - 1);
    return plot.left() + plot.width() * static_cast<double>(index) / last;
}

/// Powers of ten that hold every size.
struct Decades {
    int low = -3;
    int high = 0;
};

Decades decadesOf(const FitChart& chart) {
    double least = 1e300;
    double most = 0;
    for (const FitChart::Point& point : chart.points)
        for (const double value : {point.voxel_m, point.trustRadius_m, point.step_m}) {
            if (!(value > 0)) continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
    if (most == 0) return {};
    const int high = static_cast<int>(std::ceil(std::log10(most) - 1e-9));
    return {std::clamp(static_cast<int>(std::floor(std::log10(least) + 1e-9)), high - 6, high - 1), high};
}

QString metresText(int decade) {
    return decade >= 0    ? QStringLiteral("%1 m").arg(std::pow(10, decade), 0, 'f', 0)
           : decade >= -3 ? QStringLiteral("%1 mm").arg(std::pow(10, decade + 3), 0, 'f', 0)
                          : QStringLiteral("%1 µm").arg(std::pow(10, decade + 6), 0, 'g', 3);
}

class Painter {
  public:
    Painter(QPainter& painter, const QRectF& area, const FitChart& chart, const ChartStyle& style)
        : painter_(painter),
          area_(area),
          chart_(chart),
          style_(style),
          places_(placesIn(area, style)),
          em_(QFontMetricsF(style.font).height()),
          decades_(decadesOf(chart)) {}

    void paint() {
        painter_.save();
        painter_.setClipRect(area_);
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(style_.font);
        paintFrame();
        paintLevels();
        paintScore();
        paintSizes();
        paintCursor();
        painter_.restore();
    }

  private:
    double x(std::size_t index) const { return xOf(places_.score, chart_.points.size(), index); }
    double ySize(double metres) const {
        const double share = (std::log10(std::max(metres, 1e-12)) - decades_.low) /
                             static_cast<double>(decades_.high - decades_.low);
        return places_.sizes.bottom() - std::clamp(share, 0.0, 1.0) * places_.sizes.height();
    }

    void text(const QRectF& place, int align, const QString& words, const QColor& color) {
        painter_.setPen(color);
        painter_.drawText(place, align, words);
    }

    void paintFrame() {
        text({area_.left(), area_.top(), area_.width(), em_}, Qt::AlignLeft | Qt::AlignVCenter,
             QObject::tr("Score at each voxel size (lower is better)"), style_.text);
        painter_.setPen(QPen(style_.grid, style_.line));
        painter_.drawRect(places_.score);
        for (int decade = decades_.low; decade <= decades_.high; ++decade) {
            const double y = ySize(std::pow(10, decade));
            painter_.setPen(QPen(style_.grid, style_.line));
            painter_.drawLine(QPointF(places_.sizes.left(), y), QPointF(places_.sizes.right(), y));
            text({area_.left(), y - em_, places_.sizes.left() - area_.left() - 4, 2 * em_},
                 Qt::AlignRight | Qt::AlignVCenter, metresText(decade), style_.muted);
        }
        const double foot = places_.sizes.bottom() + 2;
        text({places_.sizes.left(), foot, places_.sizes.width(), em_}, Qt::AlignLeft | Qt::AlignTop,
             QStringLiteral("0"), style_.muted);
        text({places_.sizes.left(), foot, places_.sizes.width(), em_}, Qt::AlignRight | Qt::AlignTop,
             QString::number(chart_.points.size() - 1), style_.muted);
        text({places_.sizes.left(), foot, places_.sizes.width(), em_}, Qt::AlignHCenter | Qt::AlignTop,
             QObject::tr("iteration"), style_.muted);
    }

    std::size_t endOf(std::size_t level) const {
        return level + 1 < chart_.levels.size() ? chart_.levels[level + 1] : chart_.points.size();
    }

    void paintLevels() {
        double free = places_.score.left();
        for (std::size_t level = 0; level < chart_.levels.size(); ++level) {
            const double at = x(chart_.levels[level]);
            if (level > 0) {
                painter_.setPen(QPen(style_.grid, style_.line));
                painter_.drawLine(QPointF(at, places_.score.top()), QPointF(at, places_.sizes.bottom()));
            }
            const QString size =
                QString::fromStdString(fixedText(chart_.points[chart_.levels[level]].voxel_m, 2)) + " m";
            const double width = QFontMetricsF(style_.font).horizontalAdvance(size) + 6;
            if (at < free || at + width > area_.right()) continue;
            text({at + 2, places_.score.top() - em_ - 1, width, em_}, Qt::AlignLeft | Qt::AlignVCenter, size,
                 style_.muted);
            free = at + width;
        }
    }

    void paintScore() {
        const QColor color = style_.series.empty() ? style_.text : style_.series[0];
        for (std::size_t level = 0; level < chart_.levels.size(); ++level) {
            const std::size_t begin = chart_.levels[level];
            const std::size_t end = endOf(level);
            double low = chart_.points[begin].score;
            double high = low;
            for (std::size_t i = begin; i < end; ++i) {
                low = std::min(low, chart_.points[i].score);
                high = std::max(high, chart_.points[i].score);
            }
            const double span = high > low ? high - low : 1;
            QPolygonF line;
            for (std::size_t i = begin; i < end; ++i) {
                const double share = 0.08 + 0.84 * (high - chart_.points[i].score) / span;
                line << QPointF(x(i), places_.score.top() + share * places_.score.height());
            }
            painter_.setPen(QPen(color, 1.8 * style_.line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter_.drawPolyline(line);
            for (const QPointF& point : line) dot(point, color, true, 1.8);
        }
        const auto& shown = chart_.points[chart_.cursor.value_or(chart_.points.size() - 1)];
        text({area_.left(), area_.top(), area_.width(), em_}, Qt::AlignRight | Qt::AlignVCenter,
             QString::number(shown.score, 'g', 5), style_.text);
    }

    void dot(const QPointF& at, const QColor& color, bool filled, double radius) {
        painter_.setPen(QPen(color, style_.line));
        painter_.setBrush(filled ? color : style_.background);
        painter_.drawEllipse(at, radius * style_.line, radius * style_.line);
        painter_.setBrush(Qt::NoBrush);
    }

    void curve(const std::function<double(const FitChart::Point&)>& value, const QPen& pen) {
        QPolygonF line;
        for (std::size_t i = 0; i < chart_.points.size(); ++i) {
            const double metres = value(chart_.points[i]);
            if (metres > 0) line << QPointF(x(i), ySize(metres));
        }
        painter_.setPen(pen);
        painter_.drawPolyline(line);
    }

    void paintSizes() {
        const auto color = [&](std::size_t i) {
            return i < style_.series.size() ? style_.series[i] : style_.text;
        };
        curve([](const auto& point) { return point.voxel_m; },
              QPen(color(1), 2.4 * style_.line, Qt::SolidLine, Qt::FlatCap));
        curve([](const auto& point) { return point.trustRadius_m; },
              QPen(color(2), 1.4 * style_.line, Qt::DashLine));
        curve([](const auto& point) { return point.step_m; }, QPen(color(3), 1.2 * style_.line));
        for (std::size_t i = 0; i < chart_.points.size(); ++i)
            if (chart_.points[i].step_m > 0)
                dot({x(i), ySize(chart_.points[i].step_m)}, color(3), chart_.points[i].taken, 2.4);
        double left = area_.left();
        const double top = places_.sizes.top() - em_ - 3;
        const auto entry = [&](const QPen& pen, bool dotted, const QString& name) {
            const QPointF middle(left + 8, top + 0.5 * em_);
            painter_.setPen(pen);
            painter_.drawLine(middle - QPointF(8, 0), middle + QPointF(8, 0));
            if (dotted) dot(middle, pen.color(), true, 2.4);
            const double width = QFontMetricsF(style_.font).horizontalAdvance(name) + 8;
            text({left + 20, top, width, em_}, Qt::AlignLeft | Qt::AlignVCenter, name, style_.text);
            left += 20 + width + 6;
        };
        entry(QPen(color(1), 2.4 * style_.line), false, QObject::tr("voxel"));
        entry(QPen(color(2), 1.4 * style_.line, Qt::DashLine), false, QObject::tr("trust radius"));
        entry(QPen(color(3), 1.2 * style_.line), true, QObject::tr("step (hollow: not taken)"));
    }

    void paintCursor() {
        if (!chart_.cursor) return;
        const double at = x(*chart_.cursor);
        painter_.setPen(QPen(style_.text, 1.2 * style_.line));
        painter_.drawLine(QPointF(at, places_.score.top()), QPointF(at, places_.sizes.bottom()));
    }

    QPainter& painter_;
    QRectF area_;
    const FitChart& chart_;
    const ChartStyle& style_;
    Places places_;
    double em_;
    Decades decades_;
};

}  // namespace

void paintFitChart(QPainter& painter, const QRectF& area, const FitChart& chart, const ChartStyle& style) {
    if (chart.points.empty()) return;
    Painter(painter, area, chart, style).paint();
}

std::optional<std::size_t> iterationAt(const QRectF& area, const FitChart& chart, const ChartStyle& style,
                                       const QPointF& position) {
    if (chart.points.empty()) return std::nullopt;
    const QRectF plot = placesIn(area, style).score;
    const double share = (position.x() - plot.left()) / std::max(1.0, plot.width());
    const double last = static_cast<double>(chart.points.size() - 1);
    return static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * last));
}

}  // namespace vestige
