#include "ui/view/ViewPanes.h"

#include <algorithm>

namespace vestige {
namespace {
constexpr std::size_t kTopRight = 1;
}  // namespace

std::optional<NamedView> viewOfPane(std::size_t pane) {
    switch (pane) {
        case 0:
            return NamedView::top;
        case 2:
            return NamedView::front;
        case 3:
            return NamedView::left;
        default:
            return std::nullopt;
    }
}

void ViewPanes::setLayout(ViewLayout wanted) {
    if (wanted == layout()) return;
    const ViewCamera kept = active().camera;
    panes_.assign(wanted == ViewLayout::four ? 4 : 1, {});
    active_ = pointed_ = wanted == ViewLayout::four ? kTopRight : 0;
    for (ViewPane& pane : panes_) pane.camera = kept;
}

void ViewPanes::fit(const QSize& size) {
    const int middle = size.width() / 2;
    const int half = size.height() / 2;
    const QRect whole(QPoint(0, 0), size);
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        QRect place = whole;
        if (panes_.size() == 4) {
            if (i % 2 == 0)
                place.setRight(middle - 1);
            else
                place.setLeft(middle);
            if (i < 2)
                place.setBottom(half - 1);
            else
                place.setTop(half);
        }
        panes_[i].place = place;
        panes_[i].camera.width_px = std::max(1, place.width());
        panes_[i].camera.height_px = std::max(1, place.height());
    }
}

std::vector<QRectF> ViewPanes::viewports(const QSize& size) const {
    std::vector<QRectF> shares;
    const double width = std::max(1, size.width());
    const double height = std::max(1, size.height());
    for (const ViewPane& pane : panes_)
        shares.emplace_back(pane.place.x() / width, pane.place.y() / height, pane.place.width() / width,
                            pane.place.height() / height);
    return shares;
}

bool ViewPanes::activate(std::size_t pane) {
    if (pane == active_ || pane >= panes_.size()) return false;
    active_ = pane;
    return true;
}

std::size_t ViewPanes::at(const QPoint& position) const {
    for (std::size_t i = 0; i < panes_.size(); ++i)
        if (panes_[i].place.contains(position)) return i;
    return std::min(pointed_, panes_.size() - 1);
}

}  // namespace vestige
