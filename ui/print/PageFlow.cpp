#include "ui/print/PageFlow.h"

#include <QPainter>

namespace vestige {

PageFlow::PageFlow(const PageStyle& style) : style_(style), pages_(1), y_(style.top) {}

void PageFlow::newPage() {
    pages_.emplace_back();
    y_ = style_.top;
}

void PageFlow::keepTogether(double height) {
    if (height > remaining() && !atPageTop()) newPage();
}

void PageFlow::space(double height) {
    if (!atPageTop()) y_ += height;
}

void PageFlow::place(double height, Paint paint) {
    keepTogether(height);
    pages_.back().push_back({QPointF(style_.left, y_), std::move(paint)});
    y_ += height;
}

void PageFlow::paintPage(std::size_t page, QPainter& painter) const {
    for (const Placed& placed : pages_[page]) {
        painter.save();
        placed.paint(painter, placed.topLeft);
        painter.restore();
    }
}

}  // namespace vestige
