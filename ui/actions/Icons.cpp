#include "ui/actions/Icons.h"

#include <QBuffer>
#include <QFile>
#include <QIconEngine>
#include <QImageReader>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <algorithm>
#include <map>
#include <tuple>

namespace vestige {
namespace {

/// What the files have for lines.
constexpr const char* kInk = "#c3ccd6";

QPixmap drawn(QByteArray svg, const QColor& ink, const QSize& size) {
    svg.replace(kInk, ink.name().toLatin1());
    QBuffer buffer(&svg);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer, "svg");
    reader.setScaledSize(size);
    return QPixmap::fromImage(reader.read());
}

/// Draws at the size that is asked for, when it is asked for: sharp on every screen, and a program that
/// starts draws only what it shows.
class LineIcon : public QIconEngine {
  public:
    LineIcon(QByteArray svg, const QPalette& palette)
        : svg_(std::move(svg)),
          ink_(palette.color(QPalette::Active, QPalette::ButtonText)),
          disabled_(palette.color(QPalette::Disabled, QPalette::ButtonText)) {}

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QColor ink = mode == QIcon::Disabled ? disabled_
                           : state == QIcon::On    ? QColor(Qt::white)
                                                   : ink_;
        const auto key = std::tuple(size.width(), size.height(), ink.rgb());
        auto found = drawn_.find(key);
        if (found == drawn_.end()) found = drawn_.emplace(key, drawn(svg_, ink, size)).first;
        return found->second;
    }
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const double scale = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
        QPixmap picture = pixmap(rect.size() * scale, mode, state);
        picture.setDevicePixelRatio(scale);
        painter->drawPixmap(rect.topLeft(), picture);
    }
    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override {
        const int side = std::min(size.width(), size.height());
        return {side, side};
    }
    QIconEngine* clone() const override { return new LineIcon(*this); }

  private:
    QByteArray svg_;
    QColor ink_;
    QColor disabled_;
    std::map<std::tuple<int, int, QRgb>, QPixmap> drawn_;
};

}  // namespace

QIcon iconOn(const QPalette& palette, const QString& name) {
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QIcon(new LineIcon(file.readAll(), palette));
}

}  // namespace vestige
