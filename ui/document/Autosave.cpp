#include "ui/document/Autosave.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "core/scene/CaseFile.h"
#include "ui/document/Document.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

constexpr int kRetry_ms = 2000;
constexpr std::uint64_t kRecovery = 1;  ///< number of the history's first step

/// Without the points, which the journal does not hold and a queue must not keep in memory.
SceneState withoutData(SceneState state) {
    for (Layer& layer : state.layers) layer.data.reset();
    return state;
}

}  // namespace

Autosave::Autosave(Document& document, std::filesystem::path root, QObject* parent)
    : QObject(parent),
      document_(document),
      autosaves_(std::move(root)),
      session_(std::make_shared<CaseSession>(autosaves_)),
      step_(document.step()),
      notes_(document.notes()),
      writer_([this](const std::shared_ptr<CaseSession>& session, const CaseSession::Kept& kept,
                     std::uint64_t last) {
          QMetaObject::invokeMethod(
              this,
              // A call that waits for the window must not keep a case locked that was left.
              [this, session = std::weak_ptr(session), kept, last] {
                  if (session.lock() == session_) tell(kept, last);
              },
              Qt::QueuedConnection);
      }) {
    connect(&document_, &Document::replaced, this, [this] {
        auto left = std::exchange(
            session_, next_ ? std::exchange(next_, nullptr) : std::make_shared<CaseSession>(autosaves_));
        if (!std::exchange(keep_, false)) forget(std::move(left));
        recovered_ = false;
        step_ = document_.step();
        notes_ = document_.notes();
        state_ = State::nothing;
        problem_.clear();
    });
    connect(&document_, &Document::changed, this, [this] { watch(); });
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, [this] { enqueue({}); });
}

Autosave::~Autosave() {
    writer_.end(patience_ms_);
    const quint64 safe = std::max<quint64>(writer_.kept(), settled_);
    if (ended_ || safe >= count_) return;
    std::cerr << "vestige: "
              << tr("the last changes (%1) are not stored: %2")
                     .arg(count_ - safe)
                     .arg(problem_.isEmpty() ? tr("the disk does not answer") : problem_)
                     .toStdString()
              << '\n';
}

std::shared_ptr<CaseSession> Autosave::open(const std::filesystem::path& file) {
    // The case that is open already is not taken from itself.
    if (!session_->place().empty() && session_->place() == casePlace(file) && session_->readOnly().empty())
        return session_;
    return std::make_shared<CaseSession>(autosaves_, file);
}

Result<std::shared_ptr<CaseSession>> Autosave::takeOver(const Abandoned& abandoned) {
    auto session = std::make_shared<CaseSession>(autosaves_);
    if (const Status taken = session->takeOver(abandoned); !taken) return fail(taken.error());
    return session;
}

void Autosave::follow(std::shared_ptr<CaseSession> session, bool keep) {
    next_ = std::move(session);
    keep_ = keep;
}

void Autosave::watch() {
    const std::uint64_t step = document_.step();
    const std::uint64_t notes = document_.notes();
    if (ended_ || (step == step_ && notes == notes_)) {
        emit changed();
        return;
    }
    // The journal is in English, whatever language the window speaks.
    const std::string what = step == step_  ? "note what the file is"
                             : step > step_ ? document_.lastEdit()
                                            : "undo " + document_.nextEdit();
    step_ = step;
    notes_ = notes;
    ++count_;
    if (state_ != State::failed) state_ = State::writing;
    enqueue({{what, withoutData(document_.state())}});
    emit changed();
}

void Autosave::enqueue(std::vector<CaseEdit> edits) {
    writer_.add({session_, std::move(edits), false, count_});
}

/// The session's edits are saved elsewhere, or the user does not want them.
void Autosave::forget(std::shared_ptr<CaseSession> session) {
    recovered_ = false;
    settled_ = count_;
    writer_.add({std::move(session), {}, true, count_});
}

void Autosave::tell(const CaseSession::Kept& kept, quint64 last) {
    const QString problem = said(kept.problem);
    const bool news = problem != problem_;
    problem_ = problem;
    const State before = state_;
    if (!kept.kept)
        state_ = State::failed;
    else if (last < count_)
        state_ = State::writing;
    else
        state_ = problem.isEmpty() ? State::stored : State::elsewhere;
    if (problem.isEmpty())
        retry_.stop();
    else if (!retry_.isActive())
        retry_.start();
    if (kept.kept && last > kept_) {
        kept_ = last;
        emit stored(kept_);
    }
    if (news && !problem.isEmpty()) emit troubled(text());
    if (news && problem.isEmpty() && (before == State::failed || before == State::elsewhere))
        emit troubled(tr("Autosaving works again."));
    emit changed();
}

Status Autosave::save(const std::filesystem::path& file) {
    const auto place = casePlace(file);
    const bool here = !session_->place().empty() && place == session_->place();
    const std::filesystem::path folder = isCaseStore(place) ? place : place.parent_path();
    std::error_code problem;
    const bool made = std::filesystem::create_directories(folder, problem);
    if (problem)
        return fail(ErrorCode::output, "the folder cannot be made: " + problem.message(), folder.string());
    auto session = here ? session_ : std::make_shared<CaseSession>(autosaves_, file);
    // Edits that still wait belong before the save.
    if (here && !writer_.flush(patience_ms_, session_))
        return fail(ErrorCode::output, "the disk has not yet taken the changes that were made before",
                    place.string(), "nothing was saved; try again later, or save under another name");
    const Status saved =
        document_.saveWith(file, [&](const SceneState& state) { return session->save(state); });
    if (!saved) {
        // Without its lock and what it began to write.
        session.reset();
        if (made && isCaseStore(place))
            for (const char* name : {"case.db", "case.db-journal"})
                std::filesystem::remove(place / name, problem);
        if (made) std::filesystem::remove(folder, problem);  // if it is empty
        return saved;
    }
    if (!here) forget(std::exchange(session_, session));
    recovered_ = false;
    settled_ = count_;
    state_ = State::stored;
    problem_.clear();
    retry_.stop();
    emit changed();
    return saved;
}

QString Autosave::readOnly() const {
    return said(session_->readOnly());
}

QString Autosave::text() const {
    switch (state_) {
        case State::writing:
            return tr("Autosaving…");
        case State::elsewhere:
            return tr("Autosaved in your own folder: %1").arg(problem_);
        case State::failed:
            return tr("Autosave failed: %1").arg(problem_);
        case State::nothing:
        case State::stored:
            break;
    }
    if (!document_.modified()) return document_.state().file.empty() ? QString() : tr("All changes saved");
    return tr("All changes autosaved");
}

void Autosave::discardRecovered() {
    if (!canDiscardRecovered()) return;
    if (document_.step() == kRecovery) document_.undo();
    forget(session_);
}

bool Autosave::canDiscardRecovered() const {
    return recovered_ && document_.step() <= kRecovery;
}

bool Autosave::flush(int milliseconds) {
    return writer_.flush(milliseconds);
}

void Autosave::end() {
    ended_ = true;
    retry_.stop();
    forget(session_);
    if (writer_.flush(patience_ms_)) return;
    patience_ms_ = 0;  // it was waited for
    emit troubled(tr("The disk does not answer: changes that were not saved may be offered once more."));
}

}  // namespace vestige
