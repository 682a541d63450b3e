#include "ui/view/Legend.h"

#include <QObject>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/Numbers.h"
#include "ui/view/ClassColors.h"
#include "ui/view/Translated.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kPadding = 10;
constexpr double kRow = 20;
constexpr double kSwatch = 10;
constexpr double kBarWidth = 150;
constexpr double kDifferenceWidth = 214;
constexpr double kNote = 15;
constexpr double kBarHeight = 9;
constexpr std::size_t kMostRows = 16;

struct Row {
    QString text;
    std::optional<QColor> swatch;
};

QColor toQt(const Rgb& color) {
    return {color[0], color[1], color[2]};
}

QString attributeNote(const ViewDescription& view, std::size_t index) {
    const ViewLayer& layer = view.layers[index];
    if (view.overlay == Overlay::registration || view.overlay == Overlay::residual)
        return index == targetLayer(view) ? translated(" (target)") : QString();
    if (view.overlay != Overlay::none || !layer.geometry) return {};
    const PointAttributes& attributes = layer.geometry->vertices.attributes();
    if (view.colorMode == ColorMode::rgb && attributes.color.empty()) return translated(", no colour");
    if (view.colorMode == ColorMode::intensity && attributes.intensity.empty())
        return translated(", no intensity");
    if (view.colorMode == ColorMode::classification && attributes.classification.empty())
        return translated(", no classes");
    return {};
}

std::vector<Row> rows(const ViewDescription& view, const std::optional<ColorScale>& scale) {
    std::vector<Row> all;
    for (std::size_t i = 0; i < view.layers.size(); ++i) {
        const ViewLayer& layer = view.layers[i];
        if (!isDrawn(layer)) continue;
        const QString note = attributeNote(view, i);
        const bool tinted = view.overlay == Overlay::none
                                ? !note.isEmpty() || view.colorMode == ColorMode::source
                                : view.overlay != Overlay::residual;
        all.push_back({QString::fromStdString(layer.name.empty() ? layer.id : layer.name) + note,
                       tinted ? std::optional(toQt(layerTint(view, i))) : std::nullopt});
    }
    const bool compares = std::any_of(view.layers.begin(), view.layers.end(), [](const ViewLayer& layer) {
        return isDrawn(layer) && layer.residual_m;
    });
    if (scale)
        for (const std::uint8_t code : scale->classes)
            all.push_back(
                {QStringLiteral("%1 %2").arg(code).arg(className(code)), toQt(classColor(code, view.theme))});
    if (view.overlay == Overlay::none && view.colorMode == ColorMode::intensity && !scale)
        all.push_back({translated("Grey: each layer's own range of intensity"), std::nullopt});
    if (view.overlay == Overlay::residual && compares)
        all.push_back({translated("no surface of the target there"), toQt(uncomparedColor(view.theme))});
    if (all.size() > kMostRows) {
        const std::size_t more = all.size() - kMostRows;
        all.resize(kMostRows);
        all.push_back({translated("and %1 more").arg(more), std::nullopt});
    }
    return all;
}

/// Of a step of ticks: as many as tell it exactly.
int decimalsOf(double step) {
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

QString numberText(const ColorScale& scale, double value, int decimals) {
    const double factor = scale.displayFactor;
    // A true minus sign; "-0.0" would only puzzle.
    QString text = QString::fromStdString(fixedText(value * factor, decimals));
    if (text.toDouble() == 0) text.remove('-');
    if (scale.noise && value > 0) text.prepend('+');
    return text.replace('-', QChar(0x2212));
}

/// How to read signed distances, below their bar.
std::vector<QString> notes(const ColorScale& scale) {
    const bool typed = scale.typed;
    if (!scale.noise) return {};
    const double noise = *scale.noise * scale.displayFactor;
    return {translated("+ above or outside, \u2212 below or inside"),
            (typed ? translated("Range as typed; the spread is %1 %2 (1 SD)")
                   : translated("Range: 3 \u00d7 the spread of %1 %2 (1 SD)"))
                .arg(QString::fromStdString(fixedText(noise, noise >= 10  ? 0
                                                             : noise >= 1 ? 1
                                                                          : 2)),
                     QString::fromStdString(scale.unit))};
}

double barHeight(const std::optional<ColorScale>& scale) {
    return scale && scale->classes.empty() ? 54 + kNote * static_cast<double>(notes(*scale).size()) : 0;
}

/// The finest step of 1, 2 or 5 times a power of ten whose ticks have room for their numbers.
double tickStep(const QPainter& painter, const ColorScale& scale, double width) {
    const double span = scale.high - scale.low;
    const double least = span * 1e-3;
    double power = std::pow(10, std::floor(std::log10(least * scale.displayFactor)));
    for (;; power *= 10)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = digit * power / scale.displayFactor;
            if (step >= span) return step;
            const int decimals = decimalsOf(digit * power);
            double widest = 0;
            for (const double end : {scale.low, scale.high})
                widest = std::max(widest, 1.0 * painter.fontMetrics().horizontalAdvance(numberText(
                                                    scale, std::round(end / step) * step, decimals)));
            if (width * step / span >= widest + 12) return step;
        }
}

void paintBar(QPainter& painter, const ViewTheme& theme, const QRectF& place, const ColorScale& scale) {
    painter.setFont(theme.font(11));
    painter.setPen(theme.quietText);
    painter.drawText(QRectF(place.left(), place.top(), place.width(), 16), Qt::AlignLeft | Qt::AlignVCenter,
                     translated("%1, %2").arg(translated(scale.title), QString::fromStdString(scale.unit)));
    const QRectF bar(place.left(), place.top() + 20, place.width(), kBarHeight);
    const int steps = static_cast<int>(bar.width());
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int i = 0; i < steps; ++i) {
        const double value = scale.low + (scale.high - scale.low) * (i + 0.5) / steps;
        painter.fillRect(QRectF(bar.left() + i, bar.top(), 1, bar.height()), toQt(scale.at(value)));
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
    const QRectF numbers(place.left(), bar.bottom() + 5, place.width(), 16);
    painter.setPen(theme.text);
    const double step = tickStep(painter, scale, bar.width());
    const int decimals = decimalsOf(step * scale.displayFactor);
    const double span = scale.high - scale.low;
    for (double k = std::ceil(scale.low / step - 1e-9); k * step <= scale.high + 1e-9 * span; ++k) {
        const double x = bar.left() + bar.width() * (k * step - scale.low) / span;
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        const QString text = numberText(scale, k * step, decimals);
        const double width = painter.fontMetrics().horizontalAdvance(text);
        const double left = std::clamp(x - 0.5 * width, place.left(), place.right() - width);
        painter.drawText(QPointF(left, numbers.bottom() - 3), text);
    }
    painter.setFont(theme.font(11));
    painter.setPen(theme.quietText);
    double y = numbers.bottom() + 2;
    for (const QString& note : notes(scale)) {
        painter.drawText(QRectF(place.left(), y, place.width(), kNote), Qt::AlignLeft | Qt::AlignVCenter,
                         note);
        y += kNote;
    }
}

}  // namespace

QRectF paintLegend(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                   const ViewDescription& view, const std::optional<ColorScale>& scale) {
    const std::vector<Row> all = rows(view, scale);
    if (all.empty()) return {};
    painter.setFont(theme.font(12));
    const double most = std::max(80.0, 0.4 * inside.width());
    double width = !scale || !scale->classes.empty() ? 0 : scale->noise ? kDifferenceWidth : kBarWidth;
    for (const Row& row : all)
        width = std::max(width, std::min(most, painter.fontMetrics().horizontalAdvance(row.text) +
                                                   (row.swatch ? kSwatch + 8 : 0.0)));
    const double barSpace = barHeight(scale);
    const double height = 2 * kPadding - 4 + kRow * static_cast<double>(all.size()) + barSpace;
    const QRectF panel(inside.right() - width - 2 * kPadding, inside.top(), width + 2 * kPadding, height);
    painter.setPen(QPen(theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(panel.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setBrush(Qt::NoBrush);
    double y = panel.top() + kPadding - 2;
    for (const Row& row : all) {
        double x = panel.left() + kPadding;
        if (row.swatch) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(*row.swatch);
            painter.drawRoundedRect(QRectF(x, y + 0.5 * (kRow - kSwatch), kSwatch, kSwatch), 2, 2);
            painter.setBrush(Qt::NoBrush);
            x += kSwatch + 8;
        }
        painter.setPen(theme.text);
        const double room = panel.right() - kPadding - x + 1;
        painter.drawText(QRectF(x, y, room, kRow), Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(row.text, Qt::ElideMiddle, static_cast<int>(room)));
        y += kRow;
    }
    if (scale && scale->classes.empty())
        paintBar(painter, theme, QRectF(panel.left() + kPadding, y + 4, width, barSpace), *scale);
    return panel;
}

}  // namespace vestige
