#pragma once

#include <QObject>
#include <QSet>
#include <QStringList>
#include <memory>

namespace vestige {

/// Cases and files that were opened last, newest first, kept in the user's settings. Whether they still exist
/// is looked up on a thread of its own: one may lie on a drive that does not answer.
class RecentFiles : public QObject {
    Q_OBJECT

  public:
    explicit RecentFiles(QObject* parent = nullptr);
    ~RecentFiles() override;
    /// At most eight, without those that are known to be gone.
    QStringList paths() const;
    void add(const QString& path);
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
