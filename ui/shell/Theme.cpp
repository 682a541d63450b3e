#include "ui/shell/Theme.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QStyleFactory>

static void loadResources() {
    // Resources of a static library are linked only when asked for, outside of any namespace.
    Q_INIT_RESOURCE(vestige);
}

namespace vestige {
namespace {

QPalette darkPalette() {
    const QColor window(0x15, 0x1a, 0x20), base(0x10, 0x14, 0x19), text(0xd7, 0xdd, 0xe4),
        muted(0x8b, 0x96, 0xa3);
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, window);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::Button, QColor(0x1e, 0x25, 0x2d));
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, QColor(Qt::white));
    palette.setColor(QPalette::ToolTipBase, QColor(0x22, 0x2a, 0x33));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Highlight, QColor(0x25, 0x42, 0x78));
    palette.setColor(QPalette::HighlightedText, QColor(Qt::white));
    palette.setColor(QPalette::PlaceholderText, muted);
    palette.setColor(QPalette::Link, QColor(0x8a, 0xb8, 0xff));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(0x5d, 0x67, 0x72));
    return palette;
}

}  // namespace

void applyTheme() {
    static bool applied = false;
    if (applied) return;
    applied = true;
    loadResources();
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(darkPalette());
    QFont font = QApplication::font();
    if (QFontDatabase().families().contains("Inter")) font.setFamily("Inter");
    font.setPixelSize(13);
    QApplication::setFont(font);
    QFile sheet(":/style/dark.qss");
    if (sheet.open(QIODevice::ReadOnly)) qApp->setStyleSheet(QString::fromUtf8(sheet.readAll()));
}

}  // namespace vestige
