#include "ui/view/Marks.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/view/LabelPlaces.h"
#include "ui/view/SeenLine.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

void paintLine(QPainter& painter, const ViewTheme& theme, const SeenLine& line, const PaintedMark& mark) {
    const double width = mark.mark.highlighted ? 2.4 : 1.8;
    painter.setPen(QPen(theme.casing, width + 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line.a, line.b);
    QPen pen(mark.mark.highlighted ? theme.line : theme.text, width, Qt::SolidLine, Qt::RoundCap);
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

/// Room between a label's words and its edge, and between name and length.
constexpr double kPadding_px = 9;
constexpr double kGap_px = 10;
constexpr double kHeight_px = 25;
constexpr double kBriefPadding_px = 5;
constexpr double kBriefHeight_px = 18;

struct Fonts {
    QFont length;
    QFont name;
};

QString nameOf(const PaintedMark& mark) {
    return QString::fromStdString(mark.mark.name);
}

/// The value without its uncertainty.
QString briefOf(const PaintedMark& mark) {
    const QString label = QString::fromStdString(mark.mark.label);
    return label.left(label.indexOf(QString::fromUtf8(" ±")));
}

LabelWish wishOf(const Fonts& fonts, const PaintedMark& mark, const SeenLine& line) {
    LabelWish wish{QLineF(line.a, line.b), {}, {}, {}, mark.pending || mark.mark.highlighted, mark.pending};
    if (mark.mark.label.empty()) return wish;
    const QString length = QString::fromStdString(mark.mark.label);
    const double width = std::ceil(QFontMetricsF(fonts.length).horizontalAdvance(length)) + 2 * kPadding_px;
    wish.size = {width, kHeight_px};
    wish.sizeAside = wish.size;
    wish.sizeBrief = {
        std::ceil(QFontMetricsF(fonts.name).horizontalAdvance(briefOf(mark))) + 2 * kBriefPadding_px,
        kBriefHeight_px};
    if (!mark.mark.name.empty())
        wish.sizeAside.rwidth() +=
            std::ceil(QFontMetricsF(fonts.name).horizontalAdvance(nameOf(mark))) + kGap_px;
    return wish;
}

void paintLabel(QPainter& painter, const ViewTheme& theme, const Fonts& fonts, const LabelPlace& place,
                const PaintedMark& mark) {
    painter.setPen(QPen(mark.mark.highlighted ? theme.highlight : theme.panelEdge, 1));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(place.box, 5, 5);
    painter.setBrush(Qt::NoBrush);
    if (place.brief) {
        painter.setFont(fonts.name);
        painter.setPen(theme.text);
        painter.drawText(place.box, Qt::AlignCenter, briefOf(mark));
        return;
    }
    const QRectF words = place.box.adjusted(kPadding_px, 0, -kPadding_px, 0);
    painter.setFont(fonts.length);
    painter.setPen(theme.text);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(mark.mark.label));
    if (!place.leader || mark.mark.name.empty()) return;
    painter.setFont(fonts.name);
    painter.setPen(theme.quietText);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, nameOf(mark));
}

void paintLeader(QPainter& painter, const ViewTheme& theme, const QLineF& leader, bool highlighted) {
    painter.setPen(QPen(theme.casing, 3.2, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(leader);
    painter.setPen(QPen(highlighted ? theme.highlight : theme.quietText, 1.2, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(leader);
}

}  // namespace

std::vector<QRectF> paintMarks(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                               const ViewCamera& camera, const std::vector<PaintedMark>& marks,
                               std::vector<QRectF> taken) {
    std::vector<std::pair<const PaintedMark*, SeenLine>> shown;
    for (const PaintedMark& mark : marks)
        if (const auto line = seenLine(camera, mark.mark.a, mark.mark.b))
            if (const auto part = cropped(*line, picture)) shown.emplace_back(&mark, *part);
    // Those that must be told choose their places first and are painted last.
    std::stable_sort(shown.begin(), shown.end(), [](const auto& one, const auto& other) {
        const auto rank = [](const PaintedMark& mark) { return 2 * mark.pending + mark.mark.highlighted; };
        return rank(*one.first) > rank(*other.first);
    });
    const Fonts fonts{theme.font(13, true), theme.font(12)};
    std::vector<LabelWish> wishes;
    for (const auto& [mark, line] : shown) wishes.push_back(wishOf(fonts, *mark, line));
    const std::vector<std::optional<LabelPlace>> places = placeLabels(wishes, picture, std::move(taken));
    for (std::size_t i = shown.size(); i-- > 0;)
        if (places[i] && places[i]->leader)
            paintLeader(painter, theme, *places[i]->leader, shown[i].first->mark.highlighted);
    for (std::size_t i = shown.size(); i-- > 0;) {
        const auto& [mark, line] = shown[i];
        if (mark->labelOnly) continue;
        paintLine(painter, theme, line, *mark);
        if (line.aShown) paintEnd(painter, theme, line.a, *mark);
        if (line.bShown) paintEnd(painter, theme, line.b, *mark);
    }
    std::vector<QRectF> labels;
    for (std::size_t i = shown.size(); i-- > 0;) {
        if (!places[i]) continue;
        paintLabel(painter, theme, fonts, *places[i], *shown[i].first);
        labels.push_back(places[i]->box);
    }
    return labels;
}

}  // namespace vestige
