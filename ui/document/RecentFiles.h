#pragma once

#include <QDateTime>
#include <QObject>
#include <QStringList>
#include <vector>

namespace vestige {

/// Cases and files that were opened last, newest first, kept in the user's settings.
class RecentFiles : public QObject {
    Q_OBJECT

  public:
    struct Entry {
        QString path;
        QDateTime opened;  ///< invalid where it is not known
        bool exists = true;
    };

    using QObject::QObject;
    /// At most eight, those that are gone, too: they may lie on a drive that is not plugged in.
    std::vector<Entry> entries() const;
    /// Those that still exist.
    QStringList paths() const;
    void add(const QString& path);
    void remove(const QString& path);
    void clear();

  signals:
    void changed();
};

}  // namespace vestige
