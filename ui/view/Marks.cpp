#include "ui/view/Marks.h"

#include <QPainter>
#include <QVector2D>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

/// The part of a mark that lies before the camera, in pixels.
struct Segment {
    QPointF a;
    QPointF b;
    bool aShown = true;
    bool bShown = true;
};

std::optional<Segment> projected(const ViewCamera& camera, const ViewMark& mark) {
    Eigen::Vector3d a = mark.a;
    Eigen::Vector3d b = mark.b;
    Segment segment;
    if (!camera.parallel) {
        const double closest = 1e-3;
        const double depthA = (a - camera.position).dot(camera.direction());
        const double depthB = (b - camera.position).dot(camera.direction());
        if (depthA < closest && depthB < closest) return std::nullopt;
        segment.aShown = depthA >= closest;
        segment.bShown = depthB >= closest;
        if (!segment.aShown) a += (b - a) * (closest - depthA) / (depthB - depthA);
        if (!segment.bShown) b += (a - b) * (closest - depthB) / (depthA - depthB);
    }
    const auto atA = camera.project(a);
    const auto atB = camera.project(b);
    if (!atA || !atB) return std::nullopt;
    segment.a = {atA->pixel.x(), atA->pixel.y()};
    segment.b = {atB->pixel.x(), atB->pixel.y()};
    return segment;
}

/// The part inside the picture (Liang and Barsky); nothing when the line misses it.
std::optional<Segment> cropped(const Segment& whole, const QRectF& box) {
    double from = 0;
    double to = 1;
    const QPointF step = whole.b - whole.a;
    const auto cut = [&](double along, double room) {
        if (along == 0) return room >= 0;
        if (along < 0)
            from = std::max(from, room / along);
        else
            to = std::min(to, room / along);
        return from <= to;
    };
    if (!cut(-step.x(), whole.a.x() - box.left()) || !cut(step.x(), box.right() - whole.a.x()) ||
        !cut(-step.y(), whole.a.y() - box.top()) || !cut(step.y(), box.bottom() - whole.a.y()))
        return std::nullopt;
    return Segment{whole.a + from * step, whole.a + to * step, whole.aShown && from == 0,
                   whole.bShown && to == 1};
}

void paintLine(QPainter& painter, const ViewTheme& theme, const Segment& line, const PaintedMark& mark) {
    const double width = mark.mark.highlighted ? 2.4 : 1.8;
    painter.setPen(QPen(theme.casing, width + 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line.a, line.b);
    QPen pen(mark.mark.highlighted ? QColor(255, 255, 255) : theme.text, width, Qt::SolidLine, Qt::RoundCap);
    if (mark.pending) pen.setDashPattern({3, 3});
    painter.setPen(pen);
    painter.drawLine(line.a, line.b);
}

void paintEnd(QPainter& painter, const ViewTheme& theme, const QPointF& end, const PaintedMark& mark) {
    const double radius = mark.mark.highlighted || mark.pending ? 5.5 : 4.5;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.casing);
    painter.drawEllipse(end, radius + 2, radius + 2);
    painter.setPen(QPen(Qt::white, 1.6));
    painter.setBrush(mark.mark.highlighted ? theme.highlight : theme.accent);
    painter.drawEllipse(end, radius, radius);
    painter.setBrush(Qt::NoBrush);
}

/// A label stands no further off than this, or than its line is long: of many short lines far away few can be
/// told apart, and their labels would only hide the scene.
constexpr double kNearLabel_px = 34;

/// Where a label of that size can stand beside the line: at the middle first, then along it, further off;
/// `anywhere` also far from a short line.
std::vector<QRectF> labelPlaces(const Segment& line, const QSizeF& size, bool anywhere) {
    const QPointF along = line.b - line.a;
    const double length = std::hypot(along.x(), along.y());
    QPointF aside = length > 1 ? QPointF(-along.y(), along.x()) / length : QPointF(0, -1);
    if (aside.y() > 0 || (aside.y() == 0 && aside.x() < 0)) aside = -aside;
    const double reach = 0.5 * (std::abs(aside.x()) * size.width() + std::abs(aside.y()) * size.height()) + 9;
    std::vector<QRectF> places;
    for (const double distance : {0.0, 16.0, 34.0, 60.0, 95.0, 140.0}) {
        if (!anywhere && distance > std::max(kNearLabel_px, length)) break;
        for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.0, 1.0})
            for (const double side : {1.0, -1.0}) {
                const QPointF centre = line.a + share * along + side * (reach + distance) * aside;
                places.emplace_back(centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
            }
    }
    return places;
}

/// Small boxes along a line, which labels leave free.
void addAlong(const Segment& line, std::vector<QRectF>& taken) {
    const QPointF step = line.b - line.a;
    const int count = static_cast<int>(std::hypot(step.x(), step.y()) / 10);
    for (int i = 1; i < count; ++i)
        taken.emplace_back(line.a + step * i / count - QPointF(2, 2), QSizeF(4, 4));
}

double overlapArea(const QRectF& place, const std::vector<QRectF>& taken) {
    double area = 0;
    for (const QRectF& other : taken) {
        const QRectF common = place.adjusted(-3, -3, 3, 3) & other;
        if (!common.isEmpty()) area += common.width() * common.height();
    }
    return area;
}

/// The first place that is free and inside; the least bad one for a mark that must be told.
std::optional<QRectF> choosePlace(const std::vector<QRectF>& places, const QRectF& inside,
                                  const std::vector<QRectF>& taken, bool must) {
    std::optional<QRectF> best;
    double least = 0;
    for (const QRectF& place : places) {
        if (!inside.contains(place)) continue;
        const double overlap = overlapArea(place, taken);
        if (overlap == 0) return place;
        if (must && (!best || overlap < least)) {
            best = place;
            least = overlap;
        }
    }
    return best;
}

void paintLabel(QPainter& painter, const ViewTheme& theme, const QRectF& place, const PaintedMark& mark) {
    painter.setPen(QPen(mark.mark.highlighted ? theme.highlight : theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(place, 5, 5);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(theme.text);
    painter.drawText(place, Qt::AlignCenter, QString::fromStdString(mark.mark.label));
}

/// A thin line from a label that stands far off to the middle of its mark.
void paintLeader(QPainter& painter, const ViewTheme& theme, const QRectF& place, const Segment& line) {
    const QPointF middle = 0.5 * (line.a + line.b);
    const QPointF nearest(std::clamp(middle.x(), place.left(), place.right()),
                          std::clamp(middle.y(), place.top(), place.bottom()));
    if (QVector2D(nearest - middle).length() < 24) return;
    painter.setPen(QPen(theme.quietText, 1));
    painter.drawLine(nearest, middle);
}

}  // namespace

std::vector<QRectF> paintMarks(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                               const ViewCamera& camera, const std::vector<PaintedMark>& marks,
                               std::vector<QRectF> taken) {
    std::vector<std::pair<const PaintedMark*, Segment>> shown;
    for (const PaintedMark& mark : marks)
        if (const auto line = projected(camera, mark.mark))
            if (const auto part = cropped(*line, picture)) shown.emplace_back(&mark, *part);
    // Those that must be told choose their places first and are painted last.
    std::stable_sort(shown.begin(), shown.end(), [](const auto& one, const auto& other) {
        const auto rank = [](const PaintedMark& mark) { return 2 * mark.pending + mark.mark.highlighted; };
        return rank(*one.first) > rank(*other.first);
    });
    for (const auto& [mark, line] : shown)
        for (const QPointF& end : {line.a, line.b}) taken.emplace_back(end - QPointF(6, 6), QSizeF(12, 12));
    for (const auto& [mark, line] : shown) addAlong(line, taken);

    std::vector<std::optional<QRectF>> places;
    painter.setFont(theme.font(13, true));
    const QFontMetricsF metrics(painter.font());
    for (const auto& [mark, line] : shown) {
        std::optional<QRectF> place;
        if (!mark->mark.label.empty()) {
            const QString text = QString::fromStdString(mark->mark.label);
            const QSizeF size(std::ceil(metrics.horizontalAdvance(text)) + 18, 25);
            const bool must = mark->pending || mark->mark.highlighted;
            place = choosePlace(labelPlaces(line, size, must), picture.adjusted(4, 4, -4, -4), taken, must);
            if (place) taken.push_back(*place);
        }
        places.push_back(place);
    }
    for (std::size_t i = shown.size(); i-- > 0;) {
        const auto& [mark, line] = shown[i];
        if (places[i]) paintLeader(painter, theme, *places[i], line);
        paintLine(painter, theme, line, *mark);
        if (line.aShown) paintEnd(painter, theme, line.a, *mark);
        if (line.bShown) paintEnd(painter, theme, line.b, *mark);
    }
    std::vector<QRectF> labels;
    for (std::size_t i = shown.size(); i-- > 0;) {
        if (!places[i]) continue;
        paintLabel(painter, theme, *places[i], *shown[i].first);
        labels.push_back(*places[i]);
    }
    return labels;
}

}  // namespace vestige
