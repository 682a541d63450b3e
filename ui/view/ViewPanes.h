#pragma once

#include <QPoint>
#include <QRect>
#include <QRectF>
#include <optional>
#include <vector>

#include "core/geometry/ViewCamera.h"

namespace vestige {

/// How the view is divided.
enum class ViewLayout { one, four };

/// One of the pictures that the view shows, and how much of it is drawn.
struct ViewPane {
    ViewCamera camera;
    QRect place;          ///< in the widget
    bool changed = true;  ///< to be drawn anew
    double share = 0;     ///< of the points wanted that the picture holds
    bool lacks = false;   ///< it has not all points of that share
    bool atOnce = false;  ///< one step drew it
    bool isComplete() const { return !changed && !lacks && share >= 1; }
};

/// The panes of the view: one, or four with the cameras from above (top left), from the front and from the
/// left (below) beside the one there was (top right). One of them is active: it has the keys. One has the
/// mouse.
class ViewPanes {
  public:
    ViewPanes() : panes_(1) {}

    ViewLayout layout() const { return panes_.size() == 1 ? ViewLayout::one : ViewLayout::four; }
    /// Divides the widget anew; the active pane's camera stays, at the top right of four.
    void setLayout(ViewLayout layout);
    /// Cameras take the size of their place.
    void fit(const QSize& size);
    std::vector<QRectF> viewports(const QSize& size) const;

    std::vector<ViewPane>& all() { return panes_; }
    const std::vector<ViewPane>& all() const { return panes_; }
    ViewPane& active() { return panes_[active_]; }
    std::size_t activeIndex() const { return active_; }
    ViewPane& pointed() { return panes_[pointed_]; }
    std::size_t pointedIndex() const { return pointed_; }
    /// True when another one is active then.
    bool activate(std::size_t pane);
    void point(std::size_t pane) { pointed_ = pane; }
    std::size_t at(const QPoint& position) const;

  private:
    std::vector<ViewPane> panes_;
    std::size_t active_ = 0;
    std::size_t pointed_ = 0;
};

/// What the four panes look from, by their index; nothing for the one that keeps its camera.
std::optional<NamedView> viewOfPane(std::size_t pane);

}  // namespace vestige
