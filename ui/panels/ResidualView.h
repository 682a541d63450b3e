#pragma once

#include <QWidget>

#include "core/registration/RegistrationQuality.h"

namespace vestige {

/// The histogram of residuals on the dark background of a panel, millimetres.
class ResidualView : public QWidget {
    Q_OBJECT

  public:
    explicit ResidualView(QWidget* parent = nullptr);
    void setResiduals(ResidualHistogram residuals);
    QSize sizeHint() const override { return {300, 130}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    ResidualHistogram residuals_;
};

}  // namespace vestige
