#include "ui/view/Paths.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <optional>

#include "ui/view/SeenLine.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

/// With more points than these it is a curve, whose corners say nothing.
constexpr std::size_t kMostCorners = 24;
constexpr int kFillAlpha = 46;

struct SeenPiece {
    SeenLine line;
    std::size_t from;
    std::size_t to;
};

std::vector<SeenPiece> piecesOf(const ViewCamera& camera, const QRectF& picture, const ViewPath& path) {
    std::vector<SeenPiece> pieces;
    const std::size_t count = path.points.size();
    const std::size_t last = path.closed && count > 2 ? count : count - 1;
    // A little beyond the picture, so that joints at its edge are drawn.
    const QRectF around = picture.adjusted(-20, -20, 20, 20);
    for (std::size_t i = 0; i < last; ++i) {
        const std::size_t next = (i + 1) % count;
        const auto line = seenLine(camera, path.points[i], path.points[next]);
        if (!line) continue;
        if (const auto part = cropped(*line, around)) pieces.push_back({*part, i, next});
    }
    return pieces;
}

void paintFill(QPainter& painter, const QColor& color, const ViewCamera& camera, const ViewPath& path) {
    QPolygonF outline;
    for (const Eigen::Vector3d& point : path.points) {
        const auto seen = camera.project(point);
        if (!seen) return;
        outline << QPointF(seen->pixel.x(), seen->pixel.y());
    }
    QColor fill = color;
    fill.setAlpha(kFillAlpha);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(outline);
    painter.setBrush(Qt::NoBrush);
}

}  // namespace

std::vector<PaintedMark> paintPaths(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                                    const ViewCamera& camera, const std::vector<ViewPath>& paths) {
    std::vector<PaintedMark> labels;
    for (const ViewPath& path : paths) {
        if (path.points.size() < 2) continue;
        const std::vector<SeenPiece> pieces = piecesOf(camera, picture, path);
        if (pieces.empty()) continue;
        const QColor accent = path.highlighted ? theme.highlight : theme.accent;
        if (path.closed && path.points.size() > 2) paintFill(painter, accent, camera, path);
        const double width = path.highlighted ? 2.4 : 1.8;
        for (const auto& [color, breadth] : {std::pair(theme.casing, width + 2.4),
                                             std::pair(path.highlighted ? theme.line : theme.text, width)}) {
            painter.setPen(QPen(color, breadth, Qt::SolidLine, Qt::RoundCap));
            for (const SeenPiece& piece : pieces) painter.drawLine(piece.line.a, piece.line.b);
        }
        if (path.points.size() <= kMostCorners) {
            painter.setPen(QPen(Qt::white, 1.3));
            painter.setBrush(accent);
            for (const SeenPiece& piece : pieces) {
                if (piece.line.aShown) painter.drawEllipse(piece.line.a, 3.5, 3.5);
                if (piece.line.bShown) painter.drawEllipse(piece.line.b, 3.5, 3.5);
            }
            painter.setBrush(Qt::NoBrush);
        }
        const SeenPiece* longest = nullptr;
        double most = -1;
        for (const SeenPiece& piece : pieces) {
            const double length = QLineF(piece.line.a, piece.line.b).length();
            if (length > most) longest = &piece;
            most = std::max(most, length);
        }
        if (path.label.empty()) continue;
        PaintedMark label;
        label.mark = {path.points[longest->from], path.points[longest->to], path.label, path.highlighted,
                      path.name};
        label.labelOnly = true;
        labels.push_back(std::move(label));
    }
    return labels;
}

}  // namespace vestige
