#include "ui/shell/StyleColors.h"

#include <QRegularExpression>
#include <map>

namespace vestige {
namespace {

struct StyleColor {
    const char* name;
    const char* dark;
    const char* light;
};

constexpr StyleColor kColors[] = {
    {"accent", "#2f6fe4", "#1f5fd0"},
    {"line", "#262d36", "#d4dae2"},
    {"text", "#d7dde4", "#1b222c"},
    {"quiet", "#8b96a3", "#56616e"},
    {"disabled", "#5d6772", "#98a2ae"},
    {"edge", "#303a45", "#c3cbd5"},
    {"raised", "#1a2027", "#ffffff"},
    {"window", "#151a20", "#f4f6f8"},
    {"selected", "#1d2c49", "#d6e4fb"},
    {"well", "#10141a", "#ffffff"},
    {"bright", "#eef2f6", "#0d1219"},
    {"focus", "#4c7fdc", "#2f6fe4"},
    {"button-edge", "#333d48", "#bcc5d0"},
    {"groove", "#2e3742", "#c6ced8"},
    {"rule", "#2a323c", "#d4dae2"},
    {"hover", "#27303a", "#e3e8ee"},
    {"chosen", "#25407a", "#cfe0fb"},
    {"tip", "#222a33", "#ffffff"},
    {"button", "#1e252d", "#ffffff"},
    {"bar", "#12161b", "#e9edf1"},
    {"tab", "#e6ebf0", "#0d1219"},
    {"problem", "#e0705c", "#b93a26"},
    {"menu", "#c3ccd6", "#2a333e"},
    {"link-hover", "#b9d4ff", "#0d3f96"},
    {"status", "#aab4bf", "#45505c"},
    {"heading", "#9aa5b1", "#4b5663"},
    {"link", "#8ab8ff", "#1754b8"},
    {"box-hover", "#7d8a98", "#6b7885"},
    {"warning-edge", "#6b4232", "#e0b48f"},
    {"primary-disabled-text", "#66717e", "#8b96a3"},
    {"box", "#485461", "#98a2ae"},
    {"scroll-hover", "#475361", "#98a2ae"},
    {"accent-hover", "#3f7ff0", "#2f6fe4"},
    {"trouble", "#f0a08a", "#9c3414"},
    {"warning", "#3a2620", "#fdeede"},
    {"tip-edge", "#36404b", "#c3cbd5"},
    {"notice-edge", "#2b4270", "#a9c4f2"},
    {"primary-disabled-edge", "#26303c", "#d4dae2"},
    {"menu-hover", "#25303c", "#d9dfe6"},
    {"row-line", "#20272f", "#e3e8ee"},
    {"primary-disabled", "#1d2838", "#e3e8ee"},
    {"notice", "#1c2a44", "#e5eefd"},
    {"row-hover", "#1a2129", "#e9edf2"},
    {"button-disabled", "#181d23", "#f0f2f5"},
    {"done", "#1f4d36", "#cfeadb"},
    {"welcome", "#0f1317", "#eef1f4"},
};

}  // namespace

QColor styleColor(const QString& name, Theme theme) {
    for (const StyleColor& color : kColors)
        if (name == QLatin1String(color.name))
            return QColor(QLatin1String(theme == Theme::light ? color.light : color.dark));
    return {};
}

QString withColors(const QString& sheet, Theme theme) {
    static const QRegularExpression name(QStringLiteral("@([a-z-]+)"));
    QString text;
    int from = 0;
    for (auto found = name.globalMatch(sheet); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QColor color = styleColor(match.captured(1), theme);
        text += sheet.mid(from, match.capturedStart() - from) +
                (color.isValid() ? color.name() : match.captured());
        from = match.capturedEnd();
    }
    return text + sheet.mid(from);
}

}  // namespace vestige
