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
    ChartStyle style;
    style.font = font();
    style.font.setPixelSize(10);
    style.text = QColor(0xd7, 0xdd, 0xe4);
    style.muted = QColor(0x8b, 0x96, 0xa3);
    style.grid = QColor(0x2a, 0x32, 0x3c);
    style.background = QColor(0x15, 0x1a, 0x20);
    style.series = {QColor(0x3f, 0x7f, 0xf0), QColor(0x7d, 0x86, 0x90), QColor(0xf2, 0xab, 0x5c),
                    QColor(0x76, 0xc4, 0xa0)};
    style.showCategories = false;
    style.showValues = false;
    paintReChart(painter, QRectF(rect()).adjusted(12, 4, -12, -4), chart_, style);
}

}  // namespace vestige
