#include "ui/jobs/InlineJobRunner.h"

namespace vestige {

void InlineJobRunner::cancel() {
    control_.cancel();
    cancelWaiting_ = running_;
}

void InlineJobRunner::enqueue(Job job) {
    waiting_.push_back(std::move(job));
    if (running_) return;
    running_ = true;
    emit becameBusy();
    while (!waiting_.empty()) {
        const Job next = std::move(waiting_.front());
        waiting_.erase(waiting_.begin());
        control_ = JobControl(
            [this](double fraction, std::string_view step) {
                emit progressed(fraction, QString::fromUtf8(step.data(), static_cast<int>(step.size())));
            },
            [this](std::string_view text) {
                emit messaged(QString::fromUtf8(text.data(), static_cast<int>(text.size())));
            });
        if (cancelWaiting_) control_.cancel();
        emit started(next.title);
        const auto deliver = next.work(control_);
        if (waiting_.empty()) running_ = cancelWaiting_ = false;
        deliver();
        emit finished(next.title);
        if (!running_) break;
    }
}

void InlineJobRunner::post(std::function<void()> task) {
    task();
}

}  // namespace vestige
