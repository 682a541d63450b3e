#pragma once

#include <QImage>
#include <QWidget>

#include "ui/view/ViewTheme.h"

namespace vestige {

/// A round, magnified picture beside the cursor with a crosshair in its middle, and below it what a click
/// takes. Mouse and keys go through it.
class Loupe : public QWidget {
    Q_OBJECT

  public:
    static constexpr int kDiameter_px = 136;

    explicit Loupe(QWidget* view);

    /// `taken`: a click takes what is under the crosshair; else the crosshair is pale.
    void show(const QImage& picture, const QString& caption, bool taken, const ViewTheme& theme);
    /// Beside `cursor`, inside of the view and clear of `covered` where there is room.
    void placeBeside(const QPoint& cursor, const std::vector<QRectF>& covered);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF captionBox() const;

    QImage picture_;
    QString caption_;
    bool taken_ = false;
    ViewTheme theme_;
};

}  // namespace vestige
