#include "ui/shell/Theme.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QSettings>
#include <QStyleFactory>
#include <optional>
#include <string>

#include "ui/shell/StyleColors.h"

static void loadResources() {
    // Resources of a static library are linked only when asked for, outside of any namespace.
    Q_INIT_RESOURCE(vestige);
}

namespace vestige {
namespace {

const char* const kKey = "window/theme";

QPalette paletteOf(Theme theme) {
    const auto color = [theme](const char* name) { return styleColor(QLatin1String(name), theme); };
    QPalette palette;
    palette.setColor(QPalette::Window, color("window"));
    palette.setColor(QPalette::WindowText, color("text"));
    palette.setColor(QPalette::Base, color("well"));
    palette.setColor(QPalette::AlternateBase, color("window"));
    palette.setColor(QPalette::Text, color("text"));
    palette.setColor(QPalette::Button, color("button"));
    palette.setColor(QPalette::ButtonText, color("menu"));
    palette.setColor(QPalette::BrightText, color("bright"));
    palette.setColor(QPalette::Mid, color("rule"));
    palette.setColor(QPalette::ToolTipBase, color("tip"));
    palette.setColor(QPalette::ToolTipText, color("text"));
    palette.setColor(QPalette::Highlight, color("chosen"));
    palette.setColor(QPalette::HighlightedText, color("bright"));
    palette.setColor(QPalette::PlaceholderText, color("quiet"));
    palette.setColor(QPalette::Link, color("link"));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, color("disabled"));
    return palette;
}

/// What does not change with the theme.
void prepare() {
    loadResources();
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QFont font = QApplication::font();
    // Inter has no Chinese glyphs.
    QStringList families{font.family(), "WenQuanYi Micro Hei"};
    if (QFontDatabase().families().contains("Inter")) families.prepend("Inter");
    font.setFamilies(families);
    font.setPixelSize(13);
    QApplication::setFont(font);
}

}  // namespace

void applyTheme(Theme theme) {
    static std::optional<Theme> applied;
    if (applied == theme) return;
    if (!applied) prepare();
    applied = theme;
    QApplication::setPalette(paletteOf(theme));
    QFile sheet(":/style/window.qss");
    if (sheet.open(QIODevice::ReadOnly))
        qApp->setStyleSheet(withColors(QString::fromUtf8(sheet.readAll()), theme));
}

Theme storedTheme() {
    return themeFromName(QSettings().value(kKey).toString().toStdString()).value_or(Theme::dark);
}

void storeTheme(Theme theme) {
    QSettings().setValue(kKey, QString::fromStdString(std::string(name(theme))));
}

}  // namespace vestige
