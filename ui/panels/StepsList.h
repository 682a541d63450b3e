#pragma once

#include <QWidget>

#include "ui/document/Steps.h"

class QVBoxLayout;

namespace vestige {

/// What is missing on the way to a report, a line each; a click goes to the step.
class StepsList : public QWidget {
    Q_OBJECT

  public:
    explicit StepsList(QWidget* parent = nullptr);
    void setSteps(const std::array<StepFacts, kWaySteps>& steps);

  signals:
    void chosen(vestige::WayStep step);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void wrap();
    QVBoxLayout* column_;
    QStringList shown_;
};

}  // namespace vestige
