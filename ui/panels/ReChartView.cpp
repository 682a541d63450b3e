#include "ui/panels/ReChartView.h"

#include <QPainter>

#include "ui/charts/ReChart.h"

namespace vestige {

ReChartView::ReChartView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ReChartView::setChart(BarChart chart) {
    chart_ = std::move(chart);
    update();
}

void ReChartView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    ChartStyle style = panelChartStyle(font(), palette());
    style.showCategories = false;
    style.showValues = false;
    paintReChart(painter, QRectF(rect()).adjusted(12, 4, -12, -4), chart_, style);
}

}  // namespace vestige
