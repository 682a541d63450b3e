#pragma once

#include <QWidget>

#include "core/report/Section.h"

namespace vestige {

/// The chart of relative errors on the dark background of a panel.
class ReChartView : public QWidget {
    Q_OBJECT

  public:
    explicit ReChartView(QWidget* parent = nullptr);
    void setChart(BarChart chart);
    QSize sizeHint() const override { return {300, 190}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    BarChart chart_;
};

}  // namespace vestige
