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
    /// Colour maps and ranges.
    const Coloring& coloring() const { return coloring_; }
    /// Registered layers at their first pose.
    bool before() const { return before_; }
    double pointSize_px() const { return pointSize_px_; }
    bool sizeByDistance() const { return sizeByDistance_; }
    bool eyeDomeLighting() const { return eyeDomeLighting_; }
    bool grid() const { return grid_; }
    bool northArrow() const { return northArrow_; }

    /// What window and pictures stand on.
    Theme theme() const { return theme_; }

    /// Arrows for the ways to move that a registration leaves free.
    bool freeDirections() const { return freeDirections_; }

    /// What the scene is cut to, if it is.
    const std::optional<SectionBox>& section() const { return section_; }

    void setColorMode(ColorMode mode) { set(colorMode_, mode); }
    void setOverlay(Overlay overlay) { set(overlay_, overlay); }
    void setColoring(const Coloring& coloring) { set(coloring_, coloring); }
    void setTheme(Theme theme) {
        if (theme == theme_) return;
        theme_ = theme;
        emit themeChanged();
        emit changed();
    }
    void setBefore(bool before) { set(before_, before); }
    void setFreeDirections(bool on) { set(freeDirections_, on); }
    void setPointSize(double size_px) { set(pointSize_px_, std::clamp(size_px, 1.0, 12.0)); }
    void setSizeByDistance(bool on) { set(sizeByDistance_, on); }
    void setEyeDomeLighting(bool on) { set(eyeDomeLighting_, on); }
    void setGrid(bool on) { set(grid_, on); }
    void setNorthArrow(bool on) { set(northArrow_, on); }
    void setSection(const std::optional<SectionBox>& section) {
        if (section == section_) return;
        section_ = section;
        emit sectionChanged();
    }

  signals:
    void changed();
    void themeChanged();    ///< before changed()
    void sectionChanged();  ///< without changed(): it changes with every pixel that a face is dragged

  private:
    template <class T>
    void set(T& field, T value) {
        if (field == value) return;
        field = value;
        emit changed();
    }

    ColorMode colorMode_ = ColorMode::source;
    Overlay overlay_ = Overlay::none;
    Coloring coloring_;
    Theme theme_ = Theme::dark;
    std::optional<SectionBox> section_;
    bool before_ = false;
    bool freeDirections_ = true;
    double pointSize_px_ = 2;
    bool sizeByDistance_ = false;
    bool eyeDomeLighting_ = true;
    bool grid_ = false;
    bool northArrow_ = true;
};

}  // namespace vestige
