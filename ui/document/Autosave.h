#pragma once

#include <QObject>
#include <QTimer>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/scene/store/CaseSession.h"

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
    /// Writes what waits; the case's edits stay for the next window unless `end` was called.
    ~Autosave() override;

    /// Takes the case at `file` for this window. The session is to be handed to `follow` when the document
    /// holds the case.
    std::shared_ptr<CaseSession> open(const std::filesystem::path& file);
    /// One for a case without a place, that takes over what was left behind.
    std::shared_ptr<CaseSession> takeOver(const Abandoned& abandoned);
    /// Before the document is replaced by the session's case. The user has agreed to leave the present one:
    /// its unsaved edits are forgotten. A replacement without this call begins a case without a place.
    void follow(std::shared_ptr<CaseSession> session);

    /// Saves the document to `file`, and from then on keeps its edits there.
    Status save(const std::filesystem::path& file);
    /// Why the open case cannot be saved where it is; empty when it can.
    QString readOnly() const;

    /// What windows that are gone left behind, of cases that are not open elsewhere.
    std::vector<Abandoned> abandoned() const { return autosaves_.abandoned(); }

    enum class State { nothing, writing, stored, elsewhere, failed };
    State state() const { return state_; }
    /// "All changes saved", "All changes autosaved", "Autosave failed: the disk is full", ...
    QString text() const;

    /// Goes back from recovered edits, the document's first step, to the saved case, and forgets them.
    void discardRecovered();
    /// False once there are other edits after them.
    bool canDiscardRecovered() const;
    /// Waits until everything is written or has failed; false after `milliseconds`.
    bool flush(int milliseconds);
    /// The user leaves the case for good: writes nothing more and forgets the unsaved edits.
    void end();

  signals:
    void changed();
    /// The edits up to this one (counted from 1 since the program began) outlast everything.
    void stored(quint64 edit);
    /// Autosaving did not work, or works again: a sentence, told once.
    void troubled(const QString& sentence);

  private:
    struct Waiting {
        std::shared_ptr<CaseSession> session;
        std::vector<CaseEdit> edits;
        bool discard = false;
        quint64 last = 0;
    };
    void watch();
    void enqueue(Waiting waiting);
    void work();
    void tell(const std::shared_ptr<CaseSession>& session, const CaseSession::Kept& kept, quint64 last);

    Document& document_;
    Autosaves autosaves_;
    std::shared_ptr<CaseSession> session_;
    std::shared_ptr<CaseSession> next_;
    std::uint64_t step_ = 0;
    quint64 count_ = 0;
    quint64 kept_ = 0;
    State state_ = State::nothing;
    QString problem_;
    QTimer retry_;
    bool ended_ = false;

    std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable idle_;
    std::deque<Waiting> waiting_;
    bool busy_ = false;
    bool stop_ = false;
    std::thread worker_;
};

}  // namespace vestige
