#include "ui/view/Overlay.h"

#include <QObject>
#include <QPainter>
#include <algorithm>

#include "ui/view/Arrows.h"
#include "ui/view/Legend.h"
#include "ui/view/Marks.h"
#include "ui/view/NorthArrow.h"
#include "ui/view/Paths.h"
#include "ui/view/PlanGrid.h"
#include "ui/view/ScaleBar.h"
#include "ui/view/Split.h"
#include "ui/view/Translated.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr int kMargin = 14;

void paintPanel(QPainter& painter, const ViewTheme& theme, const QRectF& panel) {
    painter.setPen(QPen(theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(panel.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setBrush(Qt::NoBrush);
}

/// At the bottom right, left of the north arrow.
QRectF paintName(QPainter& painter, const ViewTheme& theme, const QRectF& inside, const QRectF& arrow,
                 const std::vector<QRectF>& taken, const QString& name) {
    painter.setFont(theme.font(12, true));
    const double width = painter.fontMetrics().horizontalAdvance(name) + 18;
    const double right = arrow.isNull() ? inside.right() : arrow.left() - 6;
    QRectF panel(right - width, inside.bottom() - 26, width, 26);
    // In a narrow picture the scale bar reaches so far.
    const bool crowded =
        std::any_of(taken.begin(), taken.end(), [&](const QRectF& place) { return place.intersects(panel); });
    if (crowded)
        panel.moveBottomRight({inside.right(), (arrow.isNull() ? inside.bottom() - 40 : arrow.top()) - 6});
    paintPanel(painter, theme, panel);
    painter.setPen(theme.text);
    painter.drawText(panel, Qt::AlignCenter, name);
    return panel;
}

void paintPivot(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                const Eigen::Vector3d& pivot) {
    const auto seen = camera.project(pivot);
    if (!seen) return;
    const QPointF centre(seen->pixel.x(), seen->pixel.y());
    for (const auto& [color, width] : {std::pair(theme.casing, 3.6), std::pair(theme.highlight, 1.4)}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(centre, 8, 8);
        for (const QPointF& aside : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(centre + 5 * aside, centre + 13 * aside);
    }
}

/// What else the scale bar tells.
QStringList scaleNotes(const ViewDescription& view, const ViewCamera& camera) {
    QStringList notes;
    if (view.scale.denominator) {
        const QString scale = QStringLiteral("1:%1").arg(*view.scale.denominator, 0, 'g', 7);
        notes << (view.scale.dpi ? translated("%1 at %2 dpi").arg(scale).arg(*view.scale.dpi, 0, 'g', 5)
                                 : scale);
    }
    if (view.showGrid) notes << translated("grid %1").arg(lengthInWords(gridSpacing_m(camera)));
    return notes;
}

QRectF paintTitle(QPainter& painter, const ViewTheme& theme, const QString& title) {
    painter.setFont(theme.font(15, true));
    const QRectF place(QPointF(kMargin + 9, kMargin + 5),
                       painter.fontMetrics().size(Qt::TextSingleLine, title));
    // On a panel like the legend's: white letters over pale points would not be read.
    const QRectF panel = place.adjusted(-9, -5, 9, 5);
    paintPanel(painter, theme, panel);
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
    // Lines first, under the panels.
    const bool plan = view.showGrid && showsPlan(content.camera);
    if (plan) paintPlanGrid(painter, theme, picture, content.camera);
    if (view.section && content.sectionHandles)
        paintSection(painter, theme, picture, content.camera, *view.section, content.held);
    std::vector<QRectF> taken = content.covered;
    if (view.comparison) taken.push_back(paintSplit(painter, theme, picture, *view.comparison));
    if (!view.title.empty()) taken.push_back(paintTitle(painter, theme, QString::fromStdString(view.title)));
    if (view.showLegend && content.legend) {
        QRectF below = inside;
        for (const QRectF& cover : content.covered)
            if (cover.right() > inside.center().x()) below.setTop(std::max(below.top(), cover.bottom() + 10));
        // Under so many bars it would lie over what stands at the bottom.
        constexpr double kLeastForLegend_px = 130;
        if (below.top() == inside.top() || below.height() >= kLeastForLegend_px)
            taken.push_back(paintLegend(painter, theme, below, view, content.scale));
    }
    if (view.showScaleBar)
        taken.push_back(
            paintScaleBar(painter, theme, inside, content.camera, scaleNotes(view, content.camera)));
    QRectF compass;
    if (view.showNorthArrow)
        taken.push_back(compass = paintNorthArrow(painter, theme, inside, content.camera));
    if (!content.name.isEmpty())
        taken.push_back(paintName(painter, theme, inside, compass, taken, content.name));
    if (plan) {
        const std::vector<QRectF> places =
            paintPlanCoordinates(painter, theme, picture, content.camera, taken);
        taken.insert(taken.end(), places.begin(), places.end());
    }
    for (const ViewArrow& arrow : view.arrows)
        paintArrow(painter, theme, picture, content.camera, arrow, taken);
    std::vector<PaintedMark> marks = paintPaths(painter, theme, picture, content.camera, view.paths);
    for (const ViewMark& mark : view.marks) marks.push_back({mark, false});
    if (content.pending) marks.push_back({*content.pending, true});
    paintMarks(painter, theme, picture, content.camera, marks, std::move(taken));
    if (content.pivot) paintPivot(painter, theme, content.camera, *content.pivot);
}

QString viewName(const ViewCamera& camera) {
    if (!camera.parallel) return translated("Perspective");
    const Eigen::Vector3d forward = camera.direction();
    const std::pair<Eigen::Vector3d, QString> names[] = {
        {-Eigen::Vector3d::UnitZ(), translated("Top")},  {Eigen::Vector3d::UnitZ(), translated("Bottom")},
        {Eigen::Vector3d::UnitY(), translated("Front")}, {-Eigen::Vector3d::UnitY(), translated("Back")},
        {Eigen::Vector3d::UnitX(), translated("Left")},  {-Eigen::Vector3d::UnitX(), translated("Right")}};
    for (const auto& [direction, name] : names)
        if (forward.dot(direction) > 1 - 1e-9) return name;
    return translated("Parallel");
}

}  // namespace vestige
