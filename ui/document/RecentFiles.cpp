#include "ui/document/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace vestige {
namespace {
constexpr int kKept = 8;
const char* const kKey = "recent/files";
const char* const kOpened = "recent/opened";

void store(const QStringList& paths, QVariantMap opened) {
    for (const QString& path : opened.keys())
        if (!paths.contains(path)) opened.remove(path);
    QSettings settings;
    settings.setValue(kKey, paths);
    settings.setValue(kOpened, opened);
}

}  // namespace

std::vector<RecentFiles::Entry> RecentFiles::entries() const {
    const QSettings settings;
    const QVariantMap opened = settings.value(kOpened).toMap();
    std::vector<Entry> all;
    for (const QString& path : settings.value(kKey).toStringList())
        all.push_back({path, opened.value(path).toDateTime(), QFileInfo::exists(path)});
    return all;
}

QStringList RecentFiles::paths() const {
    QStringList existing;
    for (const Entry& entry : entries())
        if (entry.exists) existing << entry.path;
    return existing;
}

void RecentFiles::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const QSettings settings;
    QStringList all = settings.value(kKey).toStringList();
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
