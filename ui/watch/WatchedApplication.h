#pragma once

#include <QApplication>

namespace vestige {

/// The application of every program with a window: an EventWatch sees its events, and an exception does not
/// unwind through Qt's event loop; what happened is said on stderr before the event counts as handled.
class WatchedApplication : public QApplication {
  public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace vestige
