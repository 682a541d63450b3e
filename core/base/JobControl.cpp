#include "core/base/JobControl.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace vestige {

struct JobControl::Shared {
    ProgressHandler onProgress;
    MessageHandler onMessage;
    std::atomic<bool> cancelled = false;
    std::mutex mutex;
};

JobControl::JobControl() : shared_(std::make_shared<Shared>()) {}

JobControl::JobControl(ProgressHandler onProgress, MessageHandler onMessage) : JobControl() {
    shared_->onProgress = std::move(onProgress);
    shared_->onMessage = std::move(onMessage);
}

void JobControl::progress(double fraction, std::string_view step) const {
    if (!shared_->onProgress) return;
    const double whole = from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0);
    const std::scoped_lock lock(shared_->mutex);
    shared_->onProgress(whole, step);
}

void JobControl::message(std::string_view text) const {
    if (!shared_->onMessage) return;
    const std::scoped_lock lock(shared_->mutex);
    shared_->onMessage(text);
}

bool JobControl::cancelled() const {
    return shared_->cancelled.load(std::memory_order_relaxed);
}

void JobControl::cancel() const {
    shared_->cancelled.store(true);
}

JobControl JobControl::sub(double from, double to) const {
    JobControl step = *this;
    step.from_ = from_ + (to_ - from_) * from;
    step.to_ = from_ + (to_ - from_) * to;
    return step;
}

}  // namespace vestige
