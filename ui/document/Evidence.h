#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <map>
#include <memory>
#include <string>

namespace vestige {

class Document;
class JobRunner;
class Notices;
struct LayerData;

/// `touched`: somebody has written to the file, or replaced it, since it was read here.
enum class EvidenceState { notRead, hashed, unchanged, touched, changed, missing };

/// Whether the files of the case are still those that became part of it: their SHA-256 then (or, where the
/// case does not know it, when they were read) against their SHA-256 now. Files are watched while the case is
/// open; one that changes is told.
class Evidence : public QObject {
    Q_OBJECT

  public:
    Evidence(Document& document, JobRunner& jobs, Notices& notices, QObject* parent = nullptr);
    EvidenceState stateOf(const std::string& layer) const;
    /// Hashes every file again, on the job runner.
    void verify();

  signals:
    void changed();

  private:
    void forgetOldData();
    void watchFiles();
    void onFileChanged(const QString& path);

    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    std::map<std::string, EvidenceState> verified_;                ///< by layer id
    std::map<std::string, std::weak_ptr<const LayerData>> known_;  ///< that it was found out of
    QFileSystemWatcher watcher_;
};

}  // namespace vestige
