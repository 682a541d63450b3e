#include "ui/watch/AnswerWatch.h"

#include <chrono>

#include "ui/watch/EventWatch.h"

namespace vestige {

AnswerWatch::AnswerWatch(const EventWatch& watched, double limit_s, std::function<void(double held_s)> tell)
    : thread_([this, &watched, limit_s, tell = std::move(tell)] {
          double next_s = limit_s;
          while (!stop_) {
              std::this_thread::sleep_for(std::chrono::milliseconds(20));
              const double held_s = 1e-9 * static_cast<double>(watched.heldFor_ns());
              if (held_s < limit_s) {
                  next_s = limit_s;
              } else if (held_s >= next_s) {
                  next_s = 2 * next_s;
                  tell(held_s);
              }
          }
      }) {}

AnswerWatch::~AnswerWatch() {
    stop_ = true;
    thread_.join();
}

}  // namespace vestige
