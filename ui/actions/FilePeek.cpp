#include "ui/actions/FilePeek.h"

#include <QMetaObject>
#include <mutex>
#include <thread>
#include <utility>

#include "ui/document/Wording.h"

namespace vestige {

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
    std::thread([mailbox = mailbox_, peek = peek_, path = wanted_, control = control_] {
        auto info = guarded(path.toStdString(), [&] { return peek(toPath(path), control); });
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
