#pragma once

#include <QObject>
#include <QPoint>
#include <algorithm>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// How the scene is shown. Not part of the case, so no edits.
class Presentation : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    ColorMode colorMode() const { return colorMode_; }
    Overlay overlay() const { return overlay_; }
    /// Registered layers at their first pose.
    bool before() const { return before_; }
    double pointSize_px() const { return pointSize_px_; }
    bool eyeDomeLighting() const { return eyeDomeLighting_; }

    /// What window and pictures stand on.
    Theme theme() const { return theme_; }

    /// Arrows for the ways to move that a registration leaves free.
    bool freeDirections() const { return freeDirections_; }

    void setColorMode(ColorMode mode) { set(colorMode_, mode); }
    void setOverlay(Overlay overlay) { set(overlay_, overlay); }
    void setTheme(Theme theme) {
        if (theme == theme_) return;
        theme_ = theme;
        emit themeChanged();
        emit changed();
    }
    void setBefore(bool before) { set(before_, before); }
    void setFreeDirections(bool on) { set(freeDirections_, on); }
    void setPointSize(double size_px) { set(pointSize_px_, std::clamp(size_px, 1.0, 12.0)); }
    void setEyeDomeLighting(bool on) { set(eyeDomeLighting_, on); }

  signals:
    void changed();
    void themeChanged();  ///< before changed()

  private:
    template <class T>
    void set(T& field, T value) {
        if (field == value) return;
        field = value;
        emit changed();
    }

    ColorMode colorMode_ = ColorMode::source;
    Overlay overlay_ = Overlay::none;
    Theme theme_ = Theme::dark;
    bool before_ = false;
    bool freeDirections_ = true;
    double pointSize_px_ = 2;
    bool eyeDomeLighting_ = true;
};

}  // namespace vestige
