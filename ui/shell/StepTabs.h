#pragma once

#include <QTabWidget>

#include "ui/document/Steps.h"

namespace vestige {

/// The panels at the right, those of one step at a time: the step bar chooses the step, tabs stand above only
/// where a step has several panels.
class StepTabs : public QTabWidget {
    Q_OBJECT

  public:
    explicit StepTabs(QWidget* parent = nullptr);
    void addPanel(WayStep step, QWidget* panel, const QString& title);
    /// The panel of the step that was shown last, else its first; nothing changes where it has none.
    void showStep(WayStep step);

  signals:
    void stepShown(vestige::WayStep step);

  private:
    WayStep stepOf(int tab) const;
    void follow();

    std::array<int, kWaySteps> last_;
    bool following_ = false;
};

}  // namespace vestige
