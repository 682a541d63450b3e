#pragma once

#include <QDateTime>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <memory>
#include <vector>

namespace vestige {

/// Cases and files that were opened last, newest first, kept in the user's settings. Whether they still exist
/// is looked up on a thread of its own: one may lie on a drive that does not answer.
class RecentFiles : public QObject {
    Q_OBJECT

  public:
    struct Entry {
        QString path;
        QDateTime opened;  ///< invalid where it is not known
        bool exists = true;
    };

    explicit RecentFiles(QObject* parent = nullptr);
    ~RecentFiles() override;
    /// At most eight, those that are gone, too: they may lie on a drive that is not plugged in. What is there
    /// is looked at by a thread; until it has, all are.
    std::vector<Entry> entries() const;
    /// Those that are not known to be gone.
    QStringList paths() const;
    void add(const QString& path);
    void remove(const QString& path);
    void clear();

  signals:
    void changed();

  private:
    struct Mailbox;
    void look();
    void arrived(const QSet<QString>& gone);

    std::shared_ptr<Mailbox> mailbox_;
    QSet<QString> gone_;
};

}  // namespace vestige
