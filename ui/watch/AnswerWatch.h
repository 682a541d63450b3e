#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace vestige {

class EventWatch;

/// A thread that looks every 20 ms whether the watched thread answers, and tells of it while it does not: a
/// block that never ends is seen, too.
class AnswerWatch {
  public:
    /// `tell` is called on this object's thread, once for an event that lasts `limit_s` and again at each
    /// doubling.
    AnswerWatch(const EventWatch& watched, double limit_s, std::function<void(double held_s)> tell);
    ~AnswerWatch();

  private:
    std::atomic<bool> stop_ = false;
    std::thread thread_;
};

}  // namespace vestige
