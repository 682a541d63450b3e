#include "ui/jobs/ThreadedJobRunner.h"

#include <QThread>
#include <condition_variable>
#include <deque>
#include <mutex>

#include "core/base/CancelScope.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {

struct ThreadedJobRunner::Private {
    struct Waiting {
        Job job;
        JobControl control;
    };
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Waiting> waiting;
    JobControl running;
    int undelivered = 0;  ///< jobs started and not yet delivered; GUI thread only
    bool stop = false;
    std::unique_ptr<QThread> worker;  ///< not a bare one: fonts, which pages are set in, are kept by QThreads
};

ThreadedJobRunner::ThreadedJobRunner(QObject* parent) : JobRunner(parent), d_(std::make_unique<Private>()) {
    d_->worker.reset(QThread::create([this] {
        while (true) {
            Private::Waiting next;
            {
                std::unique_lock lock(d_->mutex);
                d_->wake.wait(lock, [this] { return d_->stop || !d_->waiting.empty(); });
                if (d_->stop) return;
                next = std::move(d_->waiting.front());
                d_->waiting.pop_front();
                d_->running = next.control;
            }
            const QString title = next.job.title;
            // Queued calls to an object that is gone are dropped by Qt, so nothing is delivered after the
            // end.
            QMetaObject::invokeMethod(
                this, [this, title] { emit started(title); }, Qt::QueuedConnection);
            auto deliver = [&] {
                const CancelScope scope(next.control);
                return next.job.work(next.control);
            }();
            QMetaObject::invokeMethod(
                this,
                [this, title, deliver = std::move(deliver)] {
                    const WatchedTime watched("result of", title);
                    --d_->undelivered;
                    deliver();
                    emit finished(title);
                },
                Qt::QueuedConnection);
        }
    }));
    d_->worker->start();
}

ThreadedJobRunner::~ThreadedJobRunner() {
    {
        const std::lock_guard lock(d_->mutex);
        d_->stop = true;
        d_->running.cancel();
    }
    d_->wake.notify_all();
    d_->worker->wait();
}

bool ThreadedJobRunner::busy() const {
    return d_->undelivered > 0;
}

void ThreadedJobRunner::cancel() {
    const std::lock_guard lock(d_->mutex);
    d_->running.cancel();
    for (const auto& waiting : d_->waiting) waiting.control.cancel();
}

void ThreadedJobRunner::enqueue(Job job) {
    JobControl control(
        [this](double fraction, std::string_view step) {
            const QString text = QString::fromUtf8(step.data(), static_cast<int>(step.size()));
            QMetaObject::invokeMethod(
                this, [this, fraction, text] { emit progressed(fraction, text); }, Qt::QueuedConnection);
        },
        [this](std::string_view text) {
            const QString sentence = QString::fromUtf8(text.data(), static_cast<int>(text.size()));
            QMetaObject::invokeMethod(
                this, [this, sentence] { emit messaged(sentence); }, Qt::QueuedConnection);
        });
    ++d_->undelivered;
    {
        const std::lock_guard lock(d_->mutex);
        d_->waiting.push_back({std::move(job), std::move(control)});
    }
    d_->wake.notify_one();
    if (d_->undelivered == 1) emit becameBusy();
}

void ThreadedJobRunner::post(std::function<void()> task) {
    QMetaObject::invokeMethod(this, std::move(task), Qt::QueuedConnection);
}

}  // namespace vestige
