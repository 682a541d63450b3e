#pragma once

#include <QObject>
#include <map>
#include <string>

namespace vestige {

class Document;
class JobRunner;
class Notices;

enum class EvidenceState { notRead, hashed, unchanged, changed, missing };

/// Whether the files of the case are still those that were read: their SHA-256 when read against their
/// SHA-256 now.
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
    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    std::map<std::string, EvidenceState> verified_;  ///< by layer id
};

}  // namespace vestige
