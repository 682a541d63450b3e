#include "ui/document/SampleCase.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStringList>

namespace vestige {

QString sampleMark(const QString& folder) {
    return folder + "/.complete";
}

QString sampleFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/sample";
}

QString sampleCase() {
    // build/release/bin/vestige and build/sample, which run.sh makes.
    const QString built = QDir::cleanPath(QCoreApplication::applicationDirPath() + "/../../sample");
    for (const QString& folder : {sampleFolder(), built})
        if (QFileInfo::exists(sampleMark(folder)) && QFileInfo::exists(folder + "/case.json"))
            return folder + "/case.json";
    return {};
}

}  // namespace vestige
