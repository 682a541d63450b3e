#include "ui/panels/ResidualView.h"

#include <QPainter>

#include "ui/charts/Histogram.h"

namespace vestige {

ResidualView::ResidualView(QWidget* parent) : QWidget(parent) {
    setObjectName("residuals");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ResidualView::setResiduals(ResidualHistogram residuals) {
    residuals_ = std::move(residuals);
    std::size_t inside = 0;
    for (const std::size_t count : residuals_.counts) inside += count;
    setAccessibleDescription(tr("%1 points in %2 bars of %3 mm, %4 further off")
                                 .arg(inside)
                                 .arg(residuals_.counts.size())
                                 .arg(1000 * residuals_.width_m)
                                 .arg(residuals_.outside));
    update();
}

void ResidualView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintHistogram(painter, QRectF(rect()).adjusted(12, 2, -12, -2),
                   {residuals_.counts, 1000 * residuals_.width_m, "mm", residuals_.outside},
                   panelChartStyle(font(), palette()));
}

}  // namespace vestige
