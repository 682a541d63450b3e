#pragma once

#include <QObject>
#include <QStringList>

namespace vestige {

/// Cases and files that were opened last, newest first, kept in the user's settings.
class RecentFiles : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    /// Those that still exist, at most eight.
    QStringList paths() const;
    void add(const QString& path);
    void clear();

  signals:
    void changed();
};

}  // namespace vestige
