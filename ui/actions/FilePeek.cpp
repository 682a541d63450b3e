#include "ui/actions/FilePeek.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "ui/document/Wording.h"

namespace vestige {
namespace {

/// The threads that look, of all dialogs. Never destroyed, since one of them may outlast main().
struct Looks {
    std::mutex mutex;
    std::condition_variable ended;
    int running = 0;
};

Looks& looks() {
    static Looks& all = *new Looks;
    return all;
}

/// At the program's end, before what readers use is taken down; not for a disk that does not answer.
void awaitLooks() {
    std::unique_lock lock(looks().mutex);
    looks().ended.wait_for(lock, std::chrono::seconds(2), [] { return looks().running == 0; });
}

void beginLook() {
    static std::once_flag once;
    std::call_once(once, [] { qAddPostRoutine(awaitLooks); });
    const std::scoped_lock lock(looks().mutex);
    ++looks().running;
}

void endLook() {
    const std::scoped_lock lock(looks().mutex);
    --looks().running;
    looks().ended.notify_all();
}

}  // namespace

/// Outlives the object while a thread may still have something to deliver.
struct FilePeek::Mailbox {
    std::mutex mutex;
    FilePeek* owner = nullptr;
};

FilePeek::FilePeek(QObject* parent, Peek peek)
    : QObject(parent), peek_(std::move(peek)), mailbox_(std::make_shared<Mailbox>()) {
    mailbox_->owner = this;
}

FilePeek::~FilePeek() {
    control_.cancel();
    const std::lock_guard lock(mailbox_->mutex);
    mailbox_->owner = nullptr;
}

void FilePeek::look(const QString& path) {
    wanted_ = path;
    control_.cancel();
    if (!running_ && !wanted_.isEmpty()) start();
}

void FilePeek::start() {
    running_ = true;
    control_ = JobControl();
    beginLook();
    std::thread([mailbox = mailbox_, peek = peek_, path = wanted_, control = control_] {
        auto info = guarded(path.toStdString(), [&] { return peek(toPath(path), control); });
        endLook();
        const std::lock_guard lock(mailbox->mutex);
        FilePeek* owner = mailbox->owner;
        if (!owner) return;
        QMetaObject::invokeMethod(
            owner, [owner, path, info = std::move(info)] { owner->arrived(path, info); },
            Qt::QueuedConnection);
    }).detach();
}

void FilePeek::arrived(const QString& path, const Result<FileInfo>& info) {
    running_ = false;
    if (wanted_.isEmpty()) return;
    if (path != wanted_) return start();
    // Asked for again after it was called off.
    if (!info && info.error().code == ErrorCode::cancelled) return start();
    emit told(path, info);
}

}  // namespace vestige
