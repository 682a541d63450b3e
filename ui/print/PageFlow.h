#pragma once

#include <QPointF>
#include <functional>
#include <vector>

#include "ui/print/PageStyle.h"

namespace vestige {

/// Fills pages from top to bottom with things that paint themselves later, when the number of pages is known.
class PageFlow {
  public:
    /// Paints with its top left corner at the given point, in dots.
    using Paint = std::function<void(QPainter& painter, const QPointF& topLeft)>;

    explicit PageFlow(const PageStyle& style);

    const PageStyle& style() const { return style_; }
    double width() const { return style_.textWidth(); }
    /// Height that is left on this page, and that an empty page has.
    double remaining() const { return style_.height - style_.bottom - y_; }
    double pageHeight() const { return style_.height - style_.top - style_.bottom; }
    bool atPageTop() const { return y_ <= style_.top; }

    void newPage();
    /// Begins a new page unless `height` still fits (or the page is empty, where nothing more would help).
    void keepTogether(double height);
    /// Leaves a gap, none at the top of a page.
    void space(double height);
    /// Places a thing of that height, on the next page where it does not fit.
    void place(double height, Paint paint);

    std::size_t pageCount() const { return pages_.size(); }
    void paintPage(std::size_t page, QPainter& painter) const;

  private:
    struct Placed {
        QPointF topLeft;
        Paint paint;
    };
    PageStyle style_;
    std::vector<std::vector<Placed>> pages_;
    double y_;
};

}  // namespace vestige
