#pragma once

#include <QColor>
#include <QFont>

namespace vestige {

/// The colours and fonts of what is painted over the 3D picture.
struct ViewTheme {
    QColor backgroundTop{20, 25, 32};
    QColor backgroundBottom{11, 14, 18};
    QColor panel{17, 22, 29, 232};
    QColor panelEdge{46, 54, 65};
    QColor text{230, 235, 241};
    QColor quietText{139, 150, 163};
    QColor accent{47, 111, 224};
    QColor highlight{244, 154, 52};
    QColor casing{6, 9, 13, 190};

    QFont font(int pixelSize, bool bold = false) const {
        QFont font(QStringLiteral("Inter"));
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(pixelSize);
        font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
        return font;
    }
};

}  // namespace vestige
