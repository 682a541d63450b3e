#pragma once

#include <QObject>
#include <QStringList>
#include <atomic>
#include <map>
#include <vector>

#include "ui/watch/WatchedTime.h"

class QEvent;

namespace vestige {

/// Measures how long this thread, the one with the event loop, is held by each event: the time in which the
/// window does not answer. Time in drawing calls is counted apart, waiting for events within an event (a
/// dialog's loop) not at all. One at a time for a thread; it watches from construction to destruction. The
/// application has to be a WatchedApplication.
class EventWatch : public QObject {
    Q_OBJECT

  public:
    explicit EventWatch(QObject* parent = nullptr);
    ~EventWatch() override;
    /// The watch of this thread; null where there is none.
    static EventWatch* current() { return WatchedTime::current_; }

    /// What held the thread: the event with the stretches that took most of it ("QTimer Timer > refresh").
    struct Held {
        QString what;
        double worst_s = 0;
        double worstWork_s = 0;  ///< of this thread's processor: what a busy machine does not lengthen
        double total_s = 0;
        int times = 0;
    };
    /// Of events that took over 5 ms without their drawing calls; the worst first.
    std::vector<Held> held() const;
    /// Seconds without drawing calls; 0 before the first event.
    double worst_s() const { return 1e-9 * static_cast<double>(worst_ns_); }
    double worstWork_s() const { return 1e-9 * static_cast<double>(worstWork_ns_); }
    double worstDrawing_s() const { return 1e-9 * static_cast<double>(worstDrawing_ns_); }
    int events() const { return events_; }
    void forget();
    /// Sentences for people: the longest events, the longest drawing call.
    QStringList report(std::size_t most = 8) const;

    /// For another thread: nanoseconds since the event that holds this thread now began (0: none does), with
    /// the drawing calls within it.
    std::int64_t heldFor_ns() const;

  private:
    friend class WatchedTime;
    void began(WatchedTime& stretch);
    void ended(const WatchedTime& stretch);
    static std::int64_t now_ns();
    static std::int64_t work_ns();

    WatchedTime* innermost_ = nullptr;
    std::int64_t apart_ns_ = 0;  ///< so far: in drawing calls, waiting, and in events of loops within events
    std::int64_t waiting_ns_ = 0;  ///< since when the loop waits for events
    std::int64_t apartWork_ns_ = 0;
    std::int64_t worst_ns_ = 0;
    std::int64_t worstWork_ns_ = 0;
    std::int64_t worstDrawing_ns_ = 0;
    int events_ = 0;
    std::map<QString, Held> held_;
    std::atomic<std::int64_t> heldSince_ns_ = 0;
};

/// While Qt handles an event: from QApplication::notify.
class WatchedEvent : public WatchedTime {
  public:
    WatchedEvent(const QObject& receiver, const QEvent& event) {
        if (current_) beginEvent(receiver, event);
    }

  private:
    void beginEvent(const QObject& receiver, const QEvent& event);
};

}  // namespace vestige
