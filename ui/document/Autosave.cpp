#include "ui/document/Autosave.h"

#include <QElapsedTimer>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

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
                  const auto told = session.lock();
                  if (told && told == session_) tell(kept, last);
                  endSave();
              },
              Qt::QueuedConnection);
      }),
      saver_([this](const std::shared_ptr<CaseSession>&, const CaseSession::Kept&, std::uint64_t) {
          QMetaObject::invokeMethod(
              this, [this] { endSave(); }, Qt::QueuedConnection);
      }) {
    connect(&document_, &Document::replaced, this, [this] {
        auto left = std::exchange(
            session_, next_ ? std::exchange(next_, nullptr) : std::make_shared<CaseSession>(autosaves_));
        if (!std::exchange(keep_, false)) forget(std::move(left));
        for (const auto& save : saves_) save->left = true;
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
    saver_.end(patience_ms_);
    quint64 safe = std::max<quint64>(writer_.kept(), settled_);
    for (const auto& save : saves_)
        if (const auto status = save->status(); status && *status) safe = std::max<quint64>(safe, save->edit);
    if (ended_ || safe >= count_) return;
    std::cerr << "vestige: "
              << tr("the last changes (%1) are not stored: %2")
                     .arg(count_ - safe)
                     .arg(problem_.isEmpty() ? tr("the disk does not answer") : problem_)
                     .toStdString()
              << '\n';
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

void Autosave::saveAside(const std::filesystem::path& file, std::function<void(const Status&)> done) {
    auto save = std::make_shared<SavingCase>(autosaves_, session_, file, document_.state());
    save->step = document_.step();
    save->notes = document_.notes();
    save->edit = count_;
    save->here = file == document_.state().file && !session_->place().empty();
    save->done = std::move(done);
    saves_.push_back(std::move(save));
    if (saves_.size() == 1) beginSave();
    emit changed();
}

/// The writer has them one after the other: edits that still wait belong before a save of their case, and
/// later ones after it.
void Autosave::beginSave() {
    const auto& save = saves_.front();
    if (save->here)
        writer_.add({save->present(), {}, false, count_, [save] { save->saveHere(); }});
    else
        saver_.add({nullptr, {}, false, count_, [save] { save->saveElsewhere(); }});
}

/// Comes when one may be done.
void Autosave::endSave() {
    if (saves_.empty()) return;
    const auto save = saves_.front();
    const auto status = save->status();
    if (!status) return;
    if (save->isHere()) {  // under another name
        save->here = true;
        save->restart();
        return beginSave();
    }
    saves_.pop_front();
    if (*status && !save->left) takeSaved(*save);
    if (save->done) save->done(*status);
    if (!saves_.empty()) beginSave();
    emit changed();
}

void Autosave::takeSaved(const SavingCase& saved) {
    const bool here = saved.session() == session_;
    if (!here) writer_.add({std::exchange(session_, saved.session()), {}, true, count_});
    recovered_ = false;
    settled_ = std::max<quint64>(settled_, saved.edit);
    // What was done meanwhile went to the session before.
    if (!here && saved.edit != count_)
        enqueue({{document_.undoText().toStdString(), withoutData(document_.state())}});
    if (saved.edit == count_) {
        state_ = State::stored;
        problem_.clear();
        retry_.stop();
    } else {
        state_ = State::writing;
    }
    document_.markSaved(saved.file(), saved.step, saved.notes);
}

bool Autosave::giveUpSave(const std::shared_ptr<SavingCase>& save) {
    if (!save->giveUp()) return false;
    const bool first = saves_.front() == save;
    std::erase(saves_, save);
    if (first && !saves_.empty()) beginSave();
    return true;
}

Status Autosave::save(const std::filesystem::path& file, const std::function<void()>& meanwhile) {
    const auto result = std::make_shared<std::optional<Status>>();
    saveAside(file, [result](const Status& status) { *result = status; });
    const auto save = saves_.back();
    QElapsedTimer clock;
    clock.start();
    while (!*result && clock.elapsed() < patience_ms_) {
        saves_.front()->wait(std::chrono::milliseconds(20));
        endSave();
        if (meanwhile) meanwhile();
    }
    if (*result) return **result;
    const bool begun = !giveUpSave(save);
    emit changed();
    return fail(ErrorCode::output,
                begun ? "the disk has not yet taken the case"
                      : "the disk has not yet taken the changes that were made before",
                file.string(),
                begun ? "it is saved when the disk answers"
                      : "nothing was saved; try again later, or save under another name");
}

bool Autosave::awaitSaves(const std::function<void()>& meanwhile) {
    QElapsedTimer clock;
    clock.start();
    while (saving() && clock.elapsed() < patience_ms_) {
        saves_.front()->wait(std::chrono::milliseconds(20));
        endSave();
        if (meanwhile) meanwhile();
    }
    return !saving();
}

QString Autosave::readOnly() const {
    return said(session_->readOnly());
}

QString Autosave::text() const {
    if (saving()) return tr("Saving…");
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
    return writer_.flush(milliseconds) && saver_.flush(milliseconds);
}

void Autosave::end(const std::function<void()>& meanwhile) {
    ended_ = true;
    retry_.stop();
    forget(session_);
    QElapsedTimer clock;
    clock.start();
    do {
        if (writer_.flush(std::min(20, patience_ms_)) && saver_.flush(std::min(20, patience_ms_))) return;
        if (meanwhile) meanwhile();
    } while (clock.elapsed() < patience_ms_);
    patience_ms_ = 0;  // it was waited for
    emit troubled(tr("The disk does not answer: changes that were not saved may be offered once more."));
}

}  // namespace vestige
