#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace vestige {

/// How a long computation reports progress and learns that it should stop. Cheap to copy; copies and
/// sub-steps share one cancel flag. Any thread may call any function.
class JobControl {
  public:
    using ProgressHandler = std::function<void(double fraction, std::string_view step)>;
    using MessageHandler = std::function<void(std::string_view message)>;

    /// Reports to nobody and is never cancelled unless cancel() is called.
    JobControl();
    JobControl(ProgressHandler onProgress, MessageHandler onMessage);

    /// `fraction` is 0 to 1 of this (sub-)step.
    void progress(double fraction, std::string_view step = {}) const;
    /// A sentence that the user should read: a warning, a recognised unit, a skipped file.
    void message(std::string_view text) const;

    bool cancelled() const;
    void cancel() const;

    /// A sub-step that covers [from, to] of this one's progress.
    JobControl sub(double from, double to) const;

  private:
    struct Shared;
    std::shared_ptr<Shared> shared_;
    double from_ = 0;
    double to_ = 1;
};

}  // namespace vestige
