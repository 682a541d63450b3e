#include "ui/shell/WrapLayout.h"

#include <QWidget>
#include <algorithm>

namespace vestige {
namespace {

/// Of a line between groups from what stands beside it.
constexpr int kBesideGap_px = 3;

}  // namespace

WrapLayout::WrapLayout(QWidget* parent) : QLayout(parent) {}

WrapLayout::~WrapLayout() {
    for (const Item& one : items_) delete one.item;
}

void WrapLayout::addGap(QWidget* line) {
    addingGap_ = true;
    addWidget(line);
    addingGap_ = false;
}

void WrapLayout::addItem(QLayoutItem* item) {
    items_.push_back({item, addingGap_});
}

QLayoutItem* WrapLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)].item : nullptr;
}

QLayoutItem* WrapLayout::takeAt(int index) {
    if (index < 0 || index >= count()) return nullptr;
    QLayoutItem* item = items_[static_cast<std::size_t>(index)].item;
    items_.erase(items_.begin() + index);
    return item;
}

QSize WrapLayout::sizeHint() const {
    return arranged(QRect(0, 0, QWIDGETSIZE_MAX, 0), false);
}

QSize WrapLayout::minimumSize() const {
    QSize most;
    for (const Item& one : items_) most = most.expandedTo(one.item->minimumSize());
    const QMargins margins = contentsMargins();
    return most + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

void WrapLayout::setGeometry(const QRect& place) {
    QLayout::setGeometry(place);
    arranged(place, true);
}

/// The size of all rows. A row is filled first and placed then, so that its widgets stand at one height.
QSize WrapLayout::arranged(const QRect& place, bool apply) const {
    const QMargins margins = contentsMargins();
    const int left = place.left() + margins.left();
    const int room = place.width() - margins.left() - margins.right();
    int top = place.top() + margins.top();
    int widest = 0;
    std::vector<const Item*> row;
    const auto widthOf = [&](const Item& one) {
        return one.item->sizeHint().width() + (one.gap ? 2 * kBesideGap_px : 0);
    };
    const auto end = [&] {
        while (!row.empty() && row.back()->gap) {
            if (apply) row.back()->item->widget()->move(-100, -100);
            row.pop_back();
        }
        int height = 0;
        for (const Item* one : row) height = std::max(height, one->item->sizeHint().height());
        int x = left;
        for (const Item* one : row) {
            const QSize size = one->item->sizeHint();
            if (x > left) x += spacing();
            const int at = x + (one->gap ? kBesideGap_px : 0);
            if (apply) one->item->setGeometry(QRect(QPoint(at, top + (height - size.height()) / 2), size));
            x += widthOf(*one);
        }
        widest = std::max(widest, x - left);
        if (height > 0) top += height + spacing();
        row.clear();
    };
    int used = 0;
    const auto wanted = [&](const Item& one, bool first) { return widthOf(one) + (first ? 0 : spacing()); };
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Item& one = items_[i];
        if (one.item->isEmpty()) continue;
        if (one.gap && !row.empty()) {
            // A group stays together where a row can hold it.
            int group = 0;
            for (std::size_t k = i + 1; k < items_.size() && !items_[k].gap; ++k)
                group += wanted(items_[k], group == 0);
            if (group <= room && used + wanted(one, false) + spacing() + group > room) {
                end();
                used = 0;
            }
        } else if (!row.empty() && used + wanted(one, false) > room) {
            end();
            used = 0;
        }
        if (row.empty() && one.gap) {
            if (apply) one.item->widget()->move(-100, -100);
            continue;
        }
        used += wanted(one, row.empty());
        row.push_back(&one);
    }
    end();
    const int bottom = std::max(top - spacing(), place.top() + margins.top()) + margins.bottom();
    return {widest + margins.left() + margins.right(), bottom - place.top()};
}

}  // namespace vestige
