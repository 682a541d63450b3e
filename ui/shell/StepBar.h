#pragma once

#include <QWidget>
#include <array>

#include "ui/document/Steps.h"

namespace vestige {

class Document;
class Outputs;
class StepButton;

/// The way through, under the header: Import, Align, Clean, Measure, Report.
class StepBar : public QWidget {
    Q_OBJECT

  public:
    StepBar(Document& document, Outputs& outputs, QWidget* parent = nullptr);
    void setShown(WayStep step);
    /// The first that something is missing of, but for scans that are still being read.
    WayStep next() const;

  signals:
    void chosen(vestige::WayStep step);

  private:
    void follow();

    Document& document_;
    Outputs& outputs_;
    std::array<StepButton*, kWaySteps> buttons_{};
};

}  // namespace vestige
