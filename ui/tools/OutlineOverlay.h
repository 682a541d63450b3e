#pragma once

#include <QPoint>
#include <QWidget>
#include <vector>

namespace vestige {

/// Paints an outline in the making over the picture; mouse and keyboard go through it.
class OutlineOverlay : public QWidget {
  public:
    explicit OutlineOverlay(QWidget* view);
    /// Corners in pixels; the first `marked` get a dot.
    void show(std::vector<QPoint> corners, std::size_t marked);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::vector<QPoint> corners_;
    std::size_t marked_ = 0;
};

}  // namespace vestige
