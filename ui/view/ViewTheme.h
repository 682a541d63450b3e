#pragma once

#include <QColor>
#include <QFont>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// The colours and fonts of a picture's background and of what is painted over the 3D picture.
struct ViewTheme {
    QColor backgroundTop{15, 20, 26};
    QColor backgroundBottom{10, 13, 15};
    QColor panel{17, 22, 29, 232};
    QColor panelEdge{46, 54, 65};
    QColor text{230, 235, 241};
    QColor quietText{139, 150, 163};
    QColor accent{47, 111, 224};
    QColor highlight{244, 154, 52};
    QColor casing{6, 9, 13, 190};  ///< round lines, against what lies under them
    QColor line{255, 255, 255};    ///< the brightest there is: highlighted lines, the divider

    QFont font(int pixelSize, bool bold = false) const {
        QFont font(QStringLiteral("Inter"));
        // Inter has no Chinese glyphs; the system's own choice of a font for them differs from machine to
        // machine.
        font.setFamilies({QStringLiteral("Inter"), QStringLiteral("WenQuanYi Micro Hei")});
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(pixelSize);
        font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
        return font;
    }
};

/// Of pictures on that background; texts have a contrast of at least 4.5 to their panel (WCAG 2.1, AA).
inline ViewTheme viewTheme(Theme theme) {
    if (theme == Theme::dark) return {};
    ViewTheme light;
    light.backgroundTop = {255, 255, 255};
    light.backgroundBottom = {238, 241, 245};
    light.panel = {255, 255, 255, 238};
    light.panelEdge = {196, 203, 212};
    light.text = {24, 30, 38};
    light.quietText = {86, 96, 108};
    light.accent = {30, 90, 200};
    light.highlight = {196, 84, 0};
    light.casing = {255, 255, 255, 215};
    light.line = {0, 0, 0};
    return light;
}

}  // namespace vestige
