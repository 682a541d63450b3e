#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/scene/store/CaseSession.h"
#include "ui/document/CaseOpener.h"
#include "ui/document/EditWriter.h"
#include "ui/document/SavingCase.h"

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

    /// Takes cases for this window, on any thread. A session it gives is to be handed to `follow` when the
    /// document holds the case.
    CaseOpener opener() const { return {autosaves_, session_}; }
    /// Before the document is replaced by the session's case. The user has agreed to leave the present one:
    /// its unsaved edits are forgotten. A replacement without this call begins a case without a place.
    /// With `keep` they stay where they are, and are offered the next time.
    void follow(std::shared_ptr<CaseSession> session, bool keep = false);
    /// Whether the session is that of the document.
    bool isOpen(const std::shared_ptr<CaseSession>& session) const { return session == session_; }

    /// Saves the document as it is now to `file`, on a thread of its own, and from then on keeps its edits
    /// there. Edits go on meanwhile; they are edits of the saved case. `done` hears of it on the GUI thread:
    /// ErrorCode::output, and nothing is changed.
    void saveAside(const std::filesystem::path& file, std::function<void(const Status&)> done);
    /// The same, and waits for it, at most for the patience: earlier edits of the case may not be written
    /// yet. `meanwhile` is called every 20 ms.
    Status save(const std::filesystem::path& file, const std::function<void()>& meanwhile = {});
    /// A save is not done yet.
    bool saving() const { return !saves_.empty(); }
    /// Waits for those that are not, as `save` does; false where the disk takes longer.
    bool awaitSaves(const std::function<void()>& meanwhile = {});
    /// Where the open case lies (casePlace); empty when it has no place.
    const std::filesystem::path& place() const { return session_->place(); }
    /// Why the open case cannot be saved where it is; empty when it can.
    QString readOnly() const;

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
    /// too long it is told, and they are offered once more. `meanwhile` is called every 20 ms of waiting.
    void end(const std::function<void()>& meanwhile = {});

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
    void beginSave();
    void endSave();
    void takeSaved(const SavingCase& saved);
    bool giveUpSave(const std::shared_ptr<SavingCase>& save);

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
    std::deque<std::shared_ptr<SavingCase>> saves_;  ///< in order; the first is being written
    EditWriter writer_;
    EditWriter saver_;  ///< saves to other places, which need not wait for that of the open case
};

}  // namespace vestige
