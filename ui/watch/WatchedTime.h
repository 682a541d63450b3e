#pragma once

#include <QString>
#include <cstdint>

namespace vestige {

class EventWatch;

/// A stretch of time on the interface thread, from construction to destruction, for EventWatch: what was done
/// there. Stretches lie within each other. Costs a comparison while nothing is watched, and does nothing on
/// other threads.
class WatchedTime {
  public:
    /// `what`: a literal, or a class's name; `detail`: which one.
    explicit WatchedTime(const char* what, const QString& detail = {}) {
        if (current_) begin(Kind::work, what, detail);
    }
    ~WatchedTime() {
        if (watch_) end();
    }
    WatchedTime(const WatchedTime&) = delete;
    WatchedTime& operator=(const WatchedTime&) = delete;

  protected:
    /// event: handled by Qt; drawing: a call of the graphics library, whose time is nobody's own.
    enum class Kind { work, event, drawing };
    WatchedTime() = default;
    void begin(Kind kind, const char* what, const QString& detail);

    static thread_local EventWatch* current_;  ///< of this thread; null while nothing is watched
    int type_ = 0;                             ///< of an event

  private:
    void end();
    QString label() const;

    friend class EventWatch;
    EventWatch* watch_ = nullptr;
    WatchedTime* outer_ = nullptr;
    Kind kind_ = Kind::work;
    bool first_ = false;  ///< the event loop had nothing else to do
    int loop_ = 0;        ///< event loops that run within each other
    const char* what_ = "";
    QString detail_;
    std::int64_t began_ns_ = 0;
    std::int64_t apart_ns_ = 0;      ///< what did not count when it began: see EventWatch
    std::int64_t beganWork_ns_ = 0;  ///< the same in time of the processor
    std::int64_t apartWork_ns_ = 0;
    QString heaviest_;  ///< the longest stretch within, as text
    std::int64_t heaviest_ns_ = 0;
};

/// The drawing call itself: not the interface thread's own work.
class DrawingTime : public WatchedTime {
  public:
    DrawingTime() {
        if (current_) begin(Kind::drawing, "drawing", {});
    }
};

}  // namespace vestige
