#include "ui/document/EditWriter.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <utility>

namespace vestige {

struct EditWriter::Shared {
    mutable std::mutex mutex;
    std::condition_variable wake;
    std::condition_variable progress;
    std::deque<Task> waiting;
    /// Whose task is being done. Not owned: a session is closed without the mutex, which takes the disk's
    /// time.
    const CaseSession* busy = nullptr;
    Tell tell;
    std::uint64_t kept = 0;
    bool stop = false;
    bool ended = false;
};

EditWriter::EditWriter(Tell tell) : shared_(std::make_shared<Shared>()) {
    shared_->tell = std::move(tell);
    thread_ = std::thread([shared = shared_] { work(shared); });
}

EditWriter::~EditWriter() {
    end(0);
}

void EditWriter::add(Task task) {
    {
        const std::scoped_lock lock(shared_->mutex);
        shared_->waiting.push_back(std::move(task));
    }
    shared_->wake.notify_all();
}

bool EditWriter::flush(int milliseconds, const std::shared_ptr<CaseSession>& session) {
    std::unique_lock lock(shared_->mutex);
    return shared_->progress.wait_for(lock, std::chrono::milliseconds(milliseconds), [&] {
        const auto concerns = [&](const CaseSession* one) {
            return one && (!session || one == session.get());
        };
        return !concerns(shared_->busy) &&
               std::none_of(shared_->waiting.begin(), shared_->waiting.end(),
                            [&](const Task& task) { return concerns(task.session.get()); });
    });
}

bool EditWriter::end(int milliseconds) {
    if (!thread_.joinable()) return true;
    bool ended = false;
    {
        std::unique_lock lock(shared_->mutex);
        shared_->stop = true;
        shared_->wake.notify_all();
        ended = shared_->progress.wait_for(lock, std::chrono::milliseconds(milliseconds),
                                           [&] { return shared_->ended; });
        shared_->tell = nullptr;
    }
    if (ended)
        thread_.join();
    else
        thread_.detach();
    return ended;
}

std::uint64_t EditWriter::kept() const {
    const std::scoped_lock lock(shared_->mutex);
    return shared_->kept;
}

void EditWriter::work(const std::shared_ptr<Shared>& shared) {
    while (true) {
        Task next;
        {
            std::unique_lock lock(shared->mutex);
            shared->busy = nullptr;
            shared->progress.notify_all();
            shared->wake.wait(lock, [&] { return shared->stop || !shared->waiting.empty(); });
            if (shared->waiting.empty()) {
                shared->ended = true;
                shared->progress.notify_all();
                return;
            }
            next = std::move(shared->waiting.front());
            shared->waiting.pop_front();
            shared->busy = next.session.get();
            // What came in while the last was written goes in one step.
            const auto joins = [&](const Task& more) {
                return !more.discard && !more.work && more.session == next.session;
            };
            while (!next.discard && !next.work && !shared->waiting.empty() &&
                   joins(shared->waiting.front())) {
                auto& more = shared->waiting.front();
                next.edits.insert(next.edits.end(), std::make_move_iterator(more.edits.begin()),
                                  std::make_move_iterator(more.edits.end()));
                next.last = more.last;
                shared->waiting.pop_front();
            }
        }
        if (next.discard) {
            next.session->discard();
            continue;
        }
        if (next.work) {
            next.work();
            const std::scoped_lock lock(shared->mutex);
            if (shared->tell) shared->tell(nullptr, {}, 0);
            continue;
        }
        const auto kept = next.session->append(std::move(next.edits));
        const std::scoped_lock lock(shared->mutex);
        if (kept.kept) shared->kept = std::max(shared->kept, next.last);
        if (shared->tell) shared->tell(next.session, kept, next.last);
    }
}

}  // namespace vestige
