#include "ui/tools/SnapWorker.h"

namespace vestige {

SnapWorker::SnapWorker(QObject* parent) : QObject(parent) {}

SnapWorker::~SnapWorker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        waiting_.clear();
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void SnapWorker::ask(Fit fit, Answer answer, bool passing) {
    // Whoever never snaps has no thread for it.
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
    {
        const std::lock_guard lock(mutex_);
        std::erase_if(waiting_, [](const Task& task) { return task.passing; });
        waiting_.push_back({std::move(fit), std::move(answer), passing});
    }
    wake_.notify_all();
}

void SnapWorker::work() {
    for (;;) {
        Task task;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (ending_) return;
            task = std::move(waiting_.front());
            waiting_.pop_front();
        }
        auto result = std::make_shared<Result<FittedFeature>>(
            guarded("fitting a feature", [&]() -> Result<FittedFeature> { return task.fit(); }));
        QMetaObject::invokeMethod(
            this, [answer = std::move(task.answer), result] { answer(*result); }, Qt::QueuedConnection);
    }
}

}  // namespace vestige
