#include "ui/view/Overlay.h"

#include <QPainter>
#include <algorithm>

#include "ui/view/Arrows.h"
#include "ui/view/Legend.h"
#include "ui/view/Marks.h"
#include "ui/view/ScaleBar.h"
#include "ui/view/Split.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr int kMargin = 14;

QRectF paintTitle(QPainter& painter, const ViewTheme& theme, const QString& title) {
    painter.setFont(theme.font(15, true));
    const QRectF place(QPointF(kMargin + 9, kMargin + 5),
                       painter.fontMetrics().size(Qt::TextSingleLine, title));
    // On a panel like the legend's: white letters over pale points would not be read.
    const QRectF panel = place.adjusted(-9, -5, 9, 5);
    painter.setPen(QPen(theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(panel.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setPen(theme.text);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, title);
    return panel;
}

}  // namespace

void paintOverlay(QPainter& painter, const OverlayContent& content) {
    const ViewDescription& view = content.view;
    const ViewTheme theme = viewTheme(view.theme);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const QRectF picture(0, 0, content.camera.width_px, content.camera.height_px);
    const QRectF inside = picture.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    std::vector<QRectF> taken = content.covered;
    if (view.comparison) taken.push_back(paintSplit(painter, theme, picture, *view.comparison));
    if (!view.title.empty()) taken.push_back(paintTitle(painter, theme, QString::fromStdString(view.title)));
    if (view.showLegend) {
        QRectF below = inside;
        for (const QRectF& cover : content.covered)
            if (cover.right() > inside.center().x()) below.setTop(std::max(below.top(), cover.bottom() + 10));
        taken.push_back(paintLegend(painter, theme, below, view, content.scale));
    }
    if (view.showScaleBar) taken.push_back(paintScaleBar(painter, theme, inside, content.camera));
    for (const ViewArrow& arrow : view.arrows)
        paintArrow(painter, theme, picture, content.camera, arrow, taken);
    std::vector<PaintedMark> marks;
    for (const ViewMark& mark : view.marks) marks.push_back({mark, false});
    if (content.pending) marks.push_back({*content.pending, true});
    paintMarks(painter, theme, picture, content.camera, marks, std::move(taken));
}

}  // namespace vestige
