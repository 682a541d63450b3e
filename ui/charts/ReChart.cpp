#include "ui/charts/ReChart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Translation.h"

namespace vestige {
namespace {

struct Scale {
    double low = 0;
    double high = 0;
    double step = 1;
};

/// A scale with ticks at 1, 2 or 5 times a power of ten that holds zero and every value.
/// Of values that are excluded an end counts only while it leaves the others half of the height; beyond,
/// their bars are cut.
Scale niceScale(const BarChart& chart) {
    double low = 0;
    double high = 0;
    double lowest = 0;
    double highest = 0;
    for (const auto& series : chart.series)
        for (std::size_t i = 0; i < series.values.size(); ++i) {
            const auto& value = series.values[i];
            if (!value || !std::isfinite(*value)) continue;
            lowest = std::min(lowest, *value);
            highest = std::max(highest, *value);
            if (i < series.excluded.size() && series.excluded[i]) continue;
            low = std::min(low, *value);
            high = std::max(high, *value);
        }
    const double most = 2 * std::max(high, -low);
    if (most == 0 || highest <= most) high = highest;
    if (most == 0 || -lowest <= most) low = lowest;
    const double span = std::max(high - low, 1e-6);
    const double raw = span / 5;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double ratio = raw / power;
    const double step = power * (ratio <= 1 ? 1 : ratio <= 2 ? 2 : ratio <= 5 ? 5 : 10);
    // Room for the figures above and below the longest bars.
    return {low < 0 ? step * std::floor((low - 0.25 * step) / step) : 0,
            step * std::max(1.0, std::ceil((high + 0.25 * step) / step)), step};
}

QString signedText(double value, double step) {
    const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    const QString digits = QString::number(std::abs(value), 'f', decimals);
    const bool zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return zero ? digits : (value < 0 ? QString(QChar(0x2212)) : QStringLiteral("+")) + digits;
}

class Painter {
  public:
    Painter(QPainter& painter, const QRectF& area, const BarChart& chart, const ChartStyle& style)
        : painter_(painter),
          area_(area),
          chart_(chart),
          style_(style),
          metrics_(style.font),
          scale_(niceScale(chart)) {
        small_ = style.font;
        small_.setPixelSize(std::max(1, static_cast<int>(0.86 * style.font.pixelSize())));
    }

    void paint() {
        painter_.save();
        painter_.setClipRect(area_);
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(style_.font);
        placePlot();
        paintGrid();
        for (std::size_t i = 0; i < chart_.categories.size(); ++i) paintGroup(i);
        legend(true);
        painter_.restore();
    }

  private:
    void placePlot() {
        const double em = metrics_.height();
        double axis = 0;
        for (double tick = scale_.low; tick <= scale_.high + 0.5 * scale_.step; tick += scale_.step)
            axis = std::max(axis, metrics_.horizontalAdvance(signedText(tick, scale_.step)));
        plot_ = area_.adjusted(axis + em * 0.6, 0, 0, -0.3 * em);
        plot_.setTop(area_.top() + legend(false) + 0.7 * em);
        group_ = plot_.width() / std::max<std::size_t>(1, chart_.categories.size());
        double labels = 0;
        if (style_.showCategories)
            for (const auto& category : chart_.categories)
                labels = std::max(labels, static_cast<double>(wrapped(category).size()));
        plot_.setBottom(plot_.bottom() - labels * QFontMetricsF(small_).height() - 0.3 * em);
    }

    /// A category's name in lines no wider than its group, six at most.
    QStringList wrapped(const std::string& category) const {
        const QString text = QString::fromStdString(category);
        QTextLayout layout(text, small_);
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout.setTextOption(option);
        layout.beginLayout();
        QStringList lines;
        for (QTextLine line = layout.createLine(); line.isValid() && lines.size() < 6;
             line = layout.createLine()) {
            line.setLineWidth(0.94 * group_);
            lines << text.mid(line.textStart(), line.textLength()).trimmed();
        }
        layout.endLayout();
        return lines;
    }

    double y(double value) const {
        return plot_.bottom() - (value - scale_.low) / (scale_.high - scale_.low) * plot_.height();
    }

    void paintGrid() {
        const double em = metrics_.height();
        for (int k = 0; scale_.low + k * scale_.step <= scale_.high + 0.5 * scale_.step; ++k) {
            const double tick = scale_.low + k * scale_.step;
            const bool zero = std::abs(tick) < 0.5 * scale_.step;
            painter_.setPen(
                QPen(zero ? style_.text : style_.grid, zero ? 1.2 * style_.line : 0.7 * style_.line));
            painter_.drawLine(QPointF(plot_.left(), y(tick)), QPointF(plot_.right(), y(tick)));
            painter_.setPen(style_.muted);
            painter_.drawText(
                QRectF(area_.left(), y(tick) - em, plot_.left() - area_.left() - 0.4 * em, 2 * em),
                Qt::AlignRight | Qt::AlignVCenter, signedText(tick, scale_.step));
        }
    }

    void paintGroup(std::size_t category) {
        const double left = plot_.left() + group_ * static_cast<double>(category);
        const double bar = 0.72 * group_ / std::max<std::size_t>(1, chart_.series.size());
        for (std::size_t s = 0; s < chart_.series.size(); ++s)
            paintBar(QRectF(left + 0.14 * group_ + bar * static_cast<double>(s), 0, bar, 0), s, category);
        if (!style_.showCategories) return;
        const QFontMetricsF metrics(small_);
        painter_.setFont(small_);
        painter_.setPen(style_.text);
        double top = plot_.bottom() + 0.3 * metrics_.height();
        for (const QString& line : wrapped(chart_.categories[category])) {
            painter_.drawText(QRectF(left, top, group_, metrics.height()), Qt::AlignHCenter | Qt::AlignTop,
                              line);
            top += metrics.height();
        }
        painter_.setFont(style_.font);
    }

    void paintBar(const QRectF& slot, std::size_t s, std::size_t category) {
        const auto& series = chart_.series[s];
        const QColor color = seriesColor(s);
        const QFontMetricsF metrics(small_);
        painter_.setFont(small_);
        const auto& value = series.values[category];
        // Bars narrower than their figures go without.
        const bool fits =
            style_.showValues && metrics.horizontalAdvance(QStringLiteral("+0.0")) < 1.35 * slot.width();
        if (!value) {
            painter_.setPen(style_.muted);
            if (fits)
                painter_.drawText(QRectF(slot.left() - slot.width(), y(0) - metrics.height(),
                                         3 * slot.width(), metrics.height()),
                                  Qt::AlignCenter, QString::fromStdString(say("n/m")));
            return;
        }
        const bool excluded = category < series.excluded.size() && series.excluded[category];
        const double shown = std::clamp(*value, scale_.low, scale_.high);
        QRectF bar(QPointF(slot.left() + 0.06 * slot.width(), y(std::max(0.0, shown))),
                   QPointF(slot.right() - 0.06 * slot.width(), y(std::min(0.0, shown))));
        paintSwatch(bar, color, excluded);
        if (shown != *value) paintCut(bar, color, *value > 0);
        if (fits) {
            const QRectF above(slot.left() - slot.width(), bar.top() - metrics.height(), 3 * slot.width(),
                               metrics.height());
            const QRectF below(above.left(), bar.bottom(), above.width(), above.height());
            painter_.setPen(style_.text);
            painter_.drawText(*value < 0 ? below : above, Qt::AlignCenter, signedText(*value, 0.1));
        }
        painter_.setFont(style_.font);
    }

    /// A head that says that the bar goes on.
    void paintCut(const QRectF& bar, const QColor& color, bool upwards) {
        const double reach = std::max(3.0 * style_.line, 0.5 * bar.width());
        const double end = upwards ? bar.top() : bar.bottom();
        const double tip = upwards ? end - reach : end + reach;
        const double x = bar.center().x();
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(color);
        painter_.drawPolygon(QPolygonF({{x - reach, end}, {x + reach, end}, {x, tip}}));
    }

    void paintSwatch(QRectF box, const QColor& color, bool hollow) {
        if (!hollow) {
            painter_.fillRect(box, color);
            return;
        }
        const double pen = 1.2 * style_.line;
        painter_.setPen(QPen(color, pen));
        painter_.setBrush(style_.background);
        painter_.drawRect(box.adjusted(pen / 2, pen / 2, -pen / 2, -pen / 2));
    }

    /// Height of the legend, whose entries wrap.
    double legend(bool paint) {
        const double em = metrics_.height();
        double x = plot_.left();
        double y = area_.top();
        const auto entry = [&](const QColor& color, bool hollow, const QString& name) {
            const double width = metrics_.horizontalAdvance(name) + 0.9 * em;
            if (x > plot_.left() && x + width > area_.right()) {
                x = plot_.left();
                y += 1.15 * em;
            }
            if (paint) {
                paintSwatch(QRectF(x, y + 0.2 * em, 0.62 * em, 0.62 * em), color, hollow);
                painter_.setPen(style_.text);
                painter_.drawText(QRectF(x + 0.9 * em, y, width, em), Qt::AlignLeft | Qt::AlignVCenter, name);
            }
            x += width + 1.2 * em;
        };
        bool anyExcluded = false;
        for (std::size_t s = 0; s < chart_.series.size(); ++s) {
            entry(seriesColor(s), false, QString::fromStdString(say(chart_.series[s].name)));
            const auto& excluded = chart_.series[s].excluded;
            anyExcluded = anyExcluded || std::find(excluded.begin(), excluded.end(), true) != excluded.end();
        }
        if (anyExcluded) entry(style_.muted, true, QString::fromStdString(say("excluded (hollow)")));
        if (paint) {
            painter_.setPen(style_.muted);
            painter_.drawText(QRectF(area_.left(), area_.top(), plot_.left() - area_.left() - 0.4 * em, em),
                              Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(chart_.unit));
        }
        return y + em - area_.top();
    }

    QColor seriesColor(std::size_t s) const {
        return style_.series.empty() ? style_.text : style_.series[s % style_.series.size()];
    }

    QPainter& painter_;
    QRectF area_;
    const BarChart& chart_;
    const ChartStyle& style_;
    QFontMetricsF metrics_;
    Scale scale_;
    QFont small_;
    QRectF plot_;
    double group_ = 1;
};

}  // namespace

ChartStyle panelChartStyle(const QFont& font, const QPalette& palette) {
    ChartStyle style;
    style.font = font;
    style.font.setPixelSize(10);
    style.text = palette.color(QPalette::Text);
    style.muted = palette.color(QPalette::PlaceholderText);
    style.grid = palette.color(QPalette::Mid);
    style.background = palette.color(QPalette::Window);
    if (style.background.lightness() > 127)
        style.series = {QColor(0x1f, 0x5f, 0xd0), QColor(0x6b, 0x75, 0x80), QColor(0xb8, 0x5c, 0x00),
                        QColor(0x12, 0x7a, 0x55)};
    else
        style.series = {QColor(0x3f, 0x7f, 0xf0), QColor(0x7d, 0x86, 0x90), QColor(0xf2, 0xab, 0x5c),
                        QColor(0x76, 0xc4, 0xa0)};
    return style;
}

ChartStyle paperChartStyle(const QFont& font, double line) {
    ChartStyle style;
    style.font = font;
    style.line = line;
    style.text = QColor(0x1b, 0x22, 0x2c);
    style.muted = QColor(0x5b, 0x66, 0x73);
    style.grid = QColor(0xd9, 0xde, 0xe4);
    style.background = Qt::white;
    style.series = {QColor(0x1f, 0x5f, 0xb4), QColor(0xd9, 0x7a, 0x1e), QColor(0x3d, 0x8b, 0x5a),
                    QColor(0x7d, 0x5b, 0xa6), QColor(0xb8, 0x3b, 0x4a), QColor(0x2a, 0x8f, 0x9c)};
    return style;
}

void paintReChart(QPainter& painter, const QRectF& area, const BarChart& chart, const ChartStyle& style) {
    if (chart.categories.empty() || chart.series.empty()) return;
    Painter(painter, area, chart, style).paint();
}

}  // namespace vestige
