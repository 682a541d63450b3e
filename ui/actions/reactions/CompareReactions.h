#pragma once

#include <QObject>

#include "core/pipeline/ViewRenderer.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// Before and after, target and source: swipe, blink, checkerboard; and the way back to the plain view.
/// Actions and Comparison follow each other.
class CompareReactions : public QObject {
    Q_OBJECT

  public:
    explicit CompareReactions(const Workbench& bench, QObject* parent = nullptr);

  private:
    void compare(CompareMode mode, bool on);
    void follow();

    Workbench bench_;
};

}  // namespace vestige
