#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/scene/store/CaseSession.h"
#include "ui/document/EditWriter.h"

namespace vestige {

class Document;

/// Keeps every edit of the document as it is made: writes it on a thread of its own, in order, to where the
/// open case's session says, so that a killed program loses none that was told as `stored`. What fails is
/// tried again every two seconds and told until it works. GUI thread, as all signals.
class Autosave : public QObject {
    Q_OBJECT

  public:
    /// `root`: the user's folder for edits that cannot be kept with their case.
    Autosave(Document& document, std::filesystem::path root, QObject* parent = nullptr);
    /// Writes what waits, as long as `setPatience` says, and tells on stderr of edits that were not stored;
    /// the case's edits stay for the next window unless `end` was called.
    ~Autosave() override;
    /// The longest that the window waits, in `save` and at its end, for edits to be written; 10 s.
    void setPatience(int milliseconds) { patience_ms_ = milliseconds; }

    /// Takes the case at `file` for this window. The session is to be handed to `follow` when the document
    /// holds the case.
    std::shared_ptr<CaseSession> open(const std::filesystem::path& file);
    /// One for a case without a place, that takes over what was left behind. ErrorCode::input when that
    /// cannot be read.
    Result<std::shared_ptr<CaseSession>> takeOver(const Abandoned& abandoned);
    /// Before the document is replaced by the session's case. The user has agreed to leave the present one:
    /// its unsaved edits are forgotten. A replacement without this call begins a case without a place.
    /// With `keep` they stay where they are, and are offered the next time.
    void follow(std::shared_ptr<CaseSession> session, bool keep = false);
    /// Whether the session is that of the document.
    bool isOpen(const std::shared_ptr<CaseSession>& session) const { return session == session_; }

    /// Saves the document to `file`, and from then on keeps its edits there. ErrorCode::output, and nothing
    /// is changed, also when earlier edits of the case are not written in time. Waits for the disk to take
    /// it.
    Status save(const std::filesystem::path& file);
    /// Why the open case cannot be saved where it is; empty when it can.
    QString readOnly() const;

    /// What windows that are gone left behind, of cases that are not open elsewhere.
    std::vector<Abandoned> abandoned() const { return autosaves_.abandoned(); }

    enum class State { nothing, writing, stored, elsewhere, failed };
    State state() const { return state_; }
    /// "All changes saved", "All changes autosaved", "Autosave failed: the disk is full", ...
    QString text() const;

    /// The document's first step, just done, is the recovery of edits.
    void noteRecovered() { recovered_ = true; }
    /// Goes back from recovered edits to the saved case, and forgets them.
    void discardRecovered();
    /// False once there are other edits after them, they were saved, or another case is open.
    bool canDiscardRecovered() const;
    /// Waits until everything is written or has failed; false after `milliseconds`.
    bool flush(int milliseconds);
    /// The user leaves the case for good: writes nothing more and forgets the unsaved edits. Where that takes
    /// too long it is told, and they are offered once more.
    void end();

  signals:
    void changed();
    /// The edits up to this one (counted from 1 since the program began) outlast everything.
    void stored(quint64 edit);
    /// Autosaving did not work, or works again: a sentence, told once.
    void troubled(const QString& sentence);

  private:
    void watch();
    void enqueue(std::vector<CaseEdit> edits);
    void forget(std::shared_ptr<CaseSession> session);
    void tell(const CaseSession::Kept& kept, quint64 last);

    Document& document_;
    Autosaves autosaves_;
    std::shared_ptr<CaseSession> session_;
    std::shared_ptr<CaseSession> next_;
    bool keep_ = false;  ///< of the next replacement
    std::uint64_t step_ = 0;
    std::uint64_t notes_ = 0;
    quint64 count_ = 0;
    quint64 kept_ = 0;
    quint64 settled_ = 0;  ///< the edits up to this one are saved, or nobody wants them
    State state_ = State::nothing;
    QString problem_;
    QTimer retry_;
    bool ended_ = false;
    bool recovered_ = false;  ///< the first step is the recovery
    int patience_ms_ = 10000;
    EditWriter writer_;
};

}  // namespace vestige
