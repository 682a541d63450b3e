#include "ui/document/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>
#include <mutex>
#include <thread>

namespace vestige {
namespace {

constexpr int kKept = 8;
const char* const kKey = "recent/files";
const char* const kOpened = "recent/opened";

QStringList stored() {
    return QSettings().value(kKey).toStringList();
}

void store(const QStringList& paths, QVariantMap opened) {
    for (const QString& path : opened.keys())
        if (!paths.contains(path)) opened.remove(path);
    QSettings settings;
    settings.setValue(kKey, paths);
    settings.setValue(kOpened, opened);
}

}  // namespace

std::vector<RecentFiles::Entry> RecentFiles::entries() const {
    const QVariantMap opened = QSettings().value(kOpened).toMap();
    std::vector<Entry> all;
    for (const QString& path : stored())
        all.push_back({path, opened.value(path).toDateTime(), !gone_.contains(path)});
    return all;
}

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
    const QSettings settings;
    QStringList all = stored();
    all.removeAll(absolute);
    all.prepend(absolute);
    QVariantMap opened = settings.value(kOpened).toMap();
    opened[absolute] = QDateTime::currentDateTime();
    store(all.mid(0, kKept), std::move(opened));
    emit changed();
}

void RecentFiles::remove(const QString& path) {
    const QSettings settings;
    QStringList all = settings.value(kKey).toStringList();
    all.removeAll(path);
    store(all, settings.value(kOpened).toMap());
    emit changed();
}

void RecentFiles::clear() {
    store({}, {});
    emit changed();
}

}  // namespace vestige
