#include "ui/document/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>
#include <mutex>
#include <thread>

namespace vestige {
namespace {

constexpr int kKept = 8;
const char* const kKey = "recent/files";

QStringList stored() {
    return QSettings().value(kKey).toStringList();
}

}  // namespace

/// Outlives the object while a thread may still have something to deliver.
struct RecentFiles::Mailbox {
    std::mutex mutex;
    RecentFiles* owner = nullptr;
};

RecentFiles::RecentFiles(QObject* parent) : QObject(parent), mailbox_(std::make_shared<Mailbox>()) {
    mailbox_->owner = this;
    look();
}

RecentFiles::~RecentFiles() {
    const std::lock_guard lock(mailbox_->mutex);
    mailbox_->owner = nullptr;
}

void RecentFiles::look() {
    const QStringList paths = stored();
    if (paths.isEmpty()) return;
    std::thread([mailbox = mailbox_, paths] {
        QSet<QString> gone;
        for (const QString& path : paths)
            if (!QFileInfo::exists(path)) gone.insert(path);
        const std::lock_guard lock(mailbox->mutex);
        RecentFiles* owner = mailbox->owner;
        if (!owner) return;
        QMetaObject::invokeMethod(
            owner, [owner, gone] { owner->arrived(gone); }, Qt::QueuedConnection);
    }).detach();
}

void RecentFiles::arrived(const QSet<QString>& gone) {
    if (gone == gone_) return;
    gone_ = gone;
    emit changed();
}

QStringList RecentFiles::paths() const {
    QStringList existing;
    for (const QString& path : stored())
        if (!gone_.contains(path)) existing << path;
    return existing;
}

void RecentFiles::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    gone_.remove(absolute);
    QStringList all = paths();
    all.removeAll(absolute);
    all.prepend(absolute);
    QSettings().setValue(kKey, QStringList(all.mid(0, kKept)));
    emit changed();
}

void RecentFiles::clear() {
    QSettings().remove(kKey);
    emit changed();
}

}  // namespace vestige
