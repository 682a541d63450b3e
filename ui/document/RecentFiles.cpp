#include "ui/document/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace vestige {
namespace {
constexpr int kKept = 8;
const char* const kKey = "recent/files";
}  // namespace

QStringList RecentFiles::paths() const {
    QStringList existing;
    for (const QString& path : QSettings().value(kKey).toStringList())
        if (QFileInfo::exists(path)) existing << path;
    return existing;
}

void RecentFiles::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
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
