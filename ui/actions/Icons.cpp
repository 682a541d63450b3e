#include "ui/actions/Icons.h"

#include <QBuffer>
#include <QFile>
#include <QImageReader>
#include <QPalette>
#include <QPixmap>

namespace vestige {
namespace {

/// What the files have for lines.
constexpr const char* kInk = "#c3ccd6";

QPixmap drawn(QByteArray svg, const QColor& ink, int side_px) {
    svg.replace(kInk, ink.name().toLatin1());
    QBuffer buffer(&svg);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer, "svg");
    reader.setScaledSize({side_px, side_px});
    return QPixmap::fromImage(reader.read());
}

}  // namespace

QIcon iconOn(const QPalette& palette, const QString& name) {
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray svg = file.readAll();
    QIcon icon;
    for (const int side : {16, 24, 32, 48}) {
        icon.addPixmap(drawn(svg, palette.color(QPalette::Active, QPalette::ButtonText), side));
        icon.addPixmap(drawn(svg, palette.color(QPalette::Disabled, QPalette::ButtonText), side),
                       QIcon::Disabled);
        icon.addPixmap(drawn(svg, Qt::white, side), QIcon::Normal, QIcon::On);
    }
    return icon;
}

}  // namespace vestige
