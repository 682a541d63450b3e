#pragma once

#include <QObject>
#include <memory>

#include "ui/actions/Workbench.h"

namespace vestige {

class EventWatch;

/// Help > Responsiveness: what held the window, for whoever finds it slow.
class WatchReactions : public QObject {
    Q_OBJECT

  public:
    explicit WatchReactions(const Workbench& bench, QObject* parent = nullptr);
    ~WatchReactions() override;

  private:
    void tell();

    Workbench bench_;
    std::unique_ptr<EventWatch> own_;  ///< where the program was not started with one
};

}  // namespace vestige
