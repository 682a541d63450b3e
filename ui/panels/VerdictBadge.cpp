#include "ui/panels/VerdictBadge.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "ui/panels/PanelColors.h"

namespace vestige {

QString verdictWord(Verdict verdict) {
    switch (verdict) {
        case Verdict::accepted:
            return QObject::tr("Accepted");
        case Verdict::doubtful:
            return QObject::tr("Doubtful");
        case Verdict::failed:
            return QObject::tr("Failed");
        case Verdict::ambiguous:
            return QObject::tr("Ambiguous");
    }
    return {};
}

QString verdictSentence(Verdict verdict) {
    switch (verdict) {
        case Verdict::accepted:
            return QObject::tr("The pose can be relied on, within its uncertainty.");
        case Verdict::doubtful:
            return QObject::tr("The layer was moved; use the pose only if the reasons below do not matter.");
        case Verdict::failed:
            return QObject::tr("There is no pose to rely on; the layer was not moved.");
        case Verdict::ambiguous:
            return QObject::tr("Several places fit alike; the layer was not moved. Choose one below.");
    }
    return {};
}

QColor verdictColor(Verdict verdict, const QPalette& palette) {
    const bool light = isLight(palette);
    switch (verdict) {
        case Verdict::accepted:
            return light ? QColor(0x1b, 0x70, 0x45) : QColor(0x76, 0xc4, 0xa0);
        case Verdict::doubtful:
            return light ? QColor(0xa8, 0x54, 0x00) : QColor(0xf2, 0xab, 0x5c);
        case Verdict::failed:
            return light ? QColor(0xb8, 0x32, 0x20) : QColor(0xf0, 0x7a, 0x68);
        case Verdict::ambiguous:
            return light ? QColor(0x6b, 0x3f, 0xb8) : QColor(0xc0, 0x9c, 0xf5);
    }
    return {};
}

QPixmap verdictPicture(Verdict verdict, int side_px, const QWidget& on) {
    const double devicePixelRatio = on.devicePixelRatioF();
    QPixmap picture(QSize(side_px, side_px) * devicePixelRatio);
    picture.setDevicePixelRatio(devicePixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(side_px / 24.0, side_px / 24.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(verdictColor(verdict, on.palette()));
    const QPen ink(on.palette().color(QPalette::Base), 2.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    const auto polygon = [](std::initializer_list<QPointF> points) {
        return QPolygonF(QVector<QPointF>(points));
    };
    QFont letter(QStringLiteral("Inter"));
    letter.setPixelSize(15);
    letter.setWeight(QFont::Bold);
    painter.setFont(letter);
    switch (verdict) {
        case Verdict::accepted:
            painter.drawEllipse(QRectF(1, 1, 22, 22));
            painter.setPen(ink);
            painter.setBrush(Qt::NoBrush);
            painter.drawPolyline(polygon({{6.5, 12.5}, {10.5, 16.5}, {17.5, 8}}));
            break;
        case Verdict::doubtful:
            painter.drawPolygon(polygon({{12, 1}, {23.5, 22}, {0.5, 22}}));
            painter.setPen(ink);
            painter.drawLine(QPointF(12, 8.5), QPointF(12, 14));
            painter.drawPoint(QPointF(12, 18.3));
            break;
        case Verdict::failed:
            painter.drawRoundedRect(QRectF(2, 2, 20, 20), 3, 3);
            painter.setPen(ink);
            painter.drawLine(QPointF(8, 8), QPointF(16, 16));
            painter.drawLine(QPointF(16, 8), QPointF(8, 16));
            break;
        case Verdict::ambiguous:
            painter.drawPolygon(polygon({{12, 0.5}, {23.5, 12}, {12, 23.5}, {0.5, 12}}));
            painter.setPen(ink.color());
            painter.drawText(QRectF(0, 0, 24, 24), Qt::AlignCenter, QStringLiteral("?"));
            break;
    }
    return picture;
}

VerdictBadge::VerdictBadge(QWidget* parent)
    : QWidget(parent), picture_(new QLabel), word_(new QLabel), sentence_(new QLabel) {
    setObjectName("verdict");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 10, 12, 10);
    row->setSpacing(12);
    row->addWidget(picture_, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    word_->setObjectName("verdict-word");
    word_->setProperty("role", "figure");
    sentence_->setWordWrap(true);
    words->addWidget(word_);
    words->addWidget(sentence_);
    row->addLayout(words, 1);
    onPaletteChange(*this, [this] {
        if (verdict_) setVerdict(*verdict_);
    });
}

void VerdictBadge::setVerdict(Verdict verdict) {
    verdict_ = verdict;
    color_ = verdictColor(verdict, palette());
    picture_->setPixmap(verdictPicture(verdict, 24, *this));
    word_->setText(verdictWord(verdict));
    word_->setStyleSheet("color: " + color_.name());
    sentence_->setText(verdictSentence(verdict));
    setAccessibleDescription(word_->text() + ". " + sentence_->text());
    update();
}

void VerdictBadge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = color_;
    ground.setAlpha(26);
    painter.setPen(QPen(color_, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
}

}  // namespace vestige
