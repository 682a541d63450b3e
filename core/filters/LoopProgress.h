#pragma once

#include <atomic>
#include <cstddef>
#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"

namespace vestige {

/// Progress and cancelling of a parallel loop: every chunk of the loop calls done() once.
class LoopProgress {
  public:
    LoopProgress(const JobControl& control, std::size_t items, std::string step)
        : control_(control), items_(items), step_(std::move(step)) {}

    /// Throws ErrorException (cancelled) when the job should stop.
    void check() const {
        if (control_.cancelled()) throw ErrorException{cancelledError()};
    }
    /// `items` more are done; throws as check().
    void done(std::size_t items) {
        check();
        const std::size_t sum = finished_.fetch_add(items) + items;
        control_.progress(static_cast<double>(sum) / static_cast<double>(items_), step_);
    }

  private:
    const JobControl& control_;
    std::size_t items_;
    std::string step_;
    std::atomic<std::size_t> finished_ = 0;
};

}  // namespace vestige
