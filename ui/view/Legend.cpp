#include "ui/view/Legend.h"

#include <QPainter>
#include <algorithm>
#include <vector>

#include "core/base/Numbers.h"
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
constexpr std::size_t kMostRows = 12;

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
    return {};
}

std::vector<Row> rows(const ViewDescription& view) {
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
    if (view.overlay == Overlay::residual && compares)
        all.push_back({translated("no surface of the target there"), toQt(uncomparedColor(view.theme))});
    if (all.size() > kMostRows) {
        const std::size_t more = all.size() - kMostRows;
        all.resize(kMostRows);
        all.push_back({translated("and %1 more").arg(more), std::nullopt});
    }
    return all;
}

int decimalsFor(double span) {
    return span >= 50 ? 0 : span >= 5 ? 1 : 2;
}

QString numberText(const ColorScale& scale, double value) {
    const double factor = scale.displayFactor;
    const int decimals = scale.noise ? (scale.high * factor >= 10  ? 0
                                        : scale.high * factor >= 1 ? 1
                                                                   : 2)
                                     : decimalsFor((scale.high - scale.low) * factor);
    // A true minus sign; "-0.0" would only puzzle.
    QString text = QString::fromStdString(fixedText(value * factor, decimals));
    if (text.toDouble() == 0) text.remove('-');
    if (scale.noise && value > 0) text.prepend('+');
    return text.replace('-', QChar(0x2212));
}

/// How to read signed distances, below their bar.
std::vector<QString> notes(const ColorScale& scale) {
    if (!scale.noise) return {};
    const double noise = *scale.noise * scale.displayFactor;
    return {translated("+ above or outside, \u2212 below or inside"),
            translated("Range: 3 \u00d7 the spread of %1 %2 (1 SD)")
                .arg(QString::fromStdString(fixedText(noise, noise >= 10  ? 0
                                                             : noise >= 1 ? 1
                                                                          : 2)),
                     QString::fromStdString(scale.unit))};
}

double barHeight(const std::optional<ColorScale>& scale) {
    return scale ? 52 + kNote * static_cast<double>(notes(*scale).size()) : 0;
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
    const QRectF numbers(place.left(), bar.bottom() + 3, place.width(), 16);
    painter.setPen(theme.text);
    painter.drawText(numbers, Qt::AlignLeft | Qt::AlignVCenter, numberText(scale, scale.low));
    painter.drawText(numbers, Qt::AlignHCenter | Qt::AlignVCenter,
                     numberText(scale, 0.5 * (scale.low + scale.high)));
    painter.drawText(numbers, Qt::AlignRight | Qt::AlignVCenter, numberText(scale, scale.high));
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
    const std::vector<Row> all = rows(view);
    if (all.empty()) return {};
    painter.setFont(theme.font(12));
    const double most = std::max(80.0, 0.4 * inside.width());
    double width = !scale ? 0 : scale->noise ? kDifferenceWidth : kBarWidth;
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
    if (scale) paintBar(painter, theme, QRectF(panel.left() + kPadding, y + 4, width, barSpace), *scale);
    return panel;
}

}  // namespace vestige
