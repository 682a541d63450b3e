#pragma once

#include <QTimer>
#include <QWidget>
#include <string>

#include "ui/charts/FitChart.h"

class QLabel;
class QPushButton;
class QSlider;

namespace vestige {

class FitTrace;

/// The curve itself: a click or drag shows the iteration under the cursor.
class FitCurve : public QWidget {
    Q_OBJECT

  public:
    explicit FitCurve(QWidget* parent = nullptr);
    void setChart(FitChart chart);
    QSize sizeHint() const override { return {300, 230}; }

  signals:
    void wanted(std::size_t iteration);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    QRectF area() const;
    FitChart chart_;
};

/// The iterations of one layer's registration: curves while it runs, and a slider that replays them.
class FitTraceView : public QWidget {
    Q_OBJECT

  public:
    explicit FitTraceView(FitTrace& trace, QWidget* parent = nullptr);
    void setLayer(const std::string& layer);

  private:
    void fill();
    void play();

    FitTrace& trace_;
    std::string layer_;
    QWidget* content_;
    FitCurve* curve_;
    QSlider* slider_;
    QPushButton* play_;
    QLabel* step_;
    QLabel* empty_;
    QTimer timer_;
};

}  // namespace vestige
