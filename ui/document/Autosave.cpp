#include "ui/document/Autosave.h"

#include <chrono>
#include <iterator>
#include <utility>

#include "core/scene/CaseFile.h"
#include "ui/document/Document.h"

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
      step_(document.step()) {
    connect(&document_, &Document::replaced, this, [this] {
        const auto left = std::exchange(
            session_, next_ ? std::exchange(next_, nullptr) : std::make_shared<CaseSession>(autosaves_));
        enqueue({left, {}, true, count_});
        step_ = document_.step();
        state_ = State::nothing;
        problem_.clear();
    });
    connect(&document_, &Document::changed, this, [this] { watch(); });
    retry_.setInterval(kRetry_ms);
    connect(&retry_, &QTimer::timeout, this, [this] { enqueue({session_, {}, false, count_}); });
    worker_ = std::thread([this] { work(); });
}

Autosave::~Autosave() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
    }
    wake_.notify_all();
    worker_.join();
}

std::shared_ptr<CaseSession> Autosave::open(const std::filesystem::path& file) {
    // The case that is open already is not taken from itself.
    if (!session_->place().empty() && session_->place() == casePlace(file) && session_->readOnly().empty())
        return session_;
    return std::make_shared<CaseSession>(autosaves_, file);
}

std::shared_ptr<CaseSession> Autosave::takeOver(const Abandoned& abandoned) {
    auto session = std::make_shared<CaseSession>(autosaves_);
    session->takeOver(abandoned);
    return session;
}

void Autosave::follow(std::shared_ptr<CaseSession> session) {
    next_ = std::move(session);
}

void Autosave::watch() {
    const std::uint64_t step = document_.step();
    if (ended_ || step == step_) {
        emit changed();
        return;
    }
    const bool forward = step > step_;
    step_ = step;
    ++count_;
    const QString what = forward ? document_.undoText() : tr("undo %1").arg(document_.redoText());
    if (state_ != State::failed) state_ = State::writing;
    enqueue({session_, {{what.toStdString(), withoutData(document_.state())}}, false, count_});
    emit changed();
}

void Autosave::enqueue(Waiting waiting) {
    {
        const std::scoped_lock lock(mutex_);
        waiting_.push_back(std::move(waiting));
    }
    wake_.notify_all();
}

void Autosave::work() {
    while (true) {
        Waiting next;
        {
            std::unique_lock lock(mutex_);
            busy_ = false;
            if (waiting_.empty()) idle_.notify_all();
            wake_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
            if (waiting_.empty()) return;
            next = std::move(waiting_.front());
            waiting_.pop_front();
            busy_ = true;
            // What came in while the last was written goes in one step.
            while (!next.discard && !waiting_.empty() && !waiting_.front().discard &&
                   waiting_.front().session == next.session) {
                auto& more = waiting_.front();
                next.edits.insert(next.edits.end(), std::make_move_iterator(more.edits.begin()),
                                  std::make_move_iterator(more.edits.end()));
                next.last = more.last;
                waiting_.pop_front();
            }
        }
        if (next.discard) {
            next.session->discard();
            continue;
        }
        const auto kept = next.session->append(std::move(next.edits));
        // Queued calls to an object that is gone are dropped by Qt.
        QMetaObject::invokeMethod(
            this, [this, session = next.session, kept, last = next.last] { tell(session, kept, last); },
            Qt::QueuedConnection);
    }
}

void Autosave::tell(const std::shared_ptr<CaseSession>& session, const CaseSession::Kept& kept,
                    quint64 last) {
    if (session != session_) return;
    const QString problem = QString::fromStdString(kept.problem);
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
    const auto session = here ? session_ : std::make_shared<CaseSession>(autosaves_, file);
    // Edits that still wait belong before the save.
    if (here) flush(10000);
    const Status saved =
        document_.saveWith(file, [&](const SceneState& state) { return session->save(state); });
    if (!saved) {
        if (made) std::filesystem::remove(folder, problem);  // if it is empty
        return saved;
    }
    if (!here) {
        const auto left = std::exchange(session_, session);
        enqueue({left, {}, true, count_});
    }
    state_ = State::stored;
    problem_.clear();
    retry_.stop();
    emit changed();
    return saved;
}

QString Autosave::readOnly() const {
    return QString::fromStdString(session_->readOnly());
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
    enqueue({session_, {}, true, count_});
}

bool Autosave::canDiscardRecovered() const {
    return document_.step() <= kRecovery;
}

bool Autosave::flush(int milliseconds) {
    std::unique_lock lock(mutex_);
    return idle_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                          [this] { return waiting_.empty() && !busy_; });
}

void Autosave::end() {
    ended_ = true;
    retry_.stop();
    enqueue({session_, {}, true, count_});
    flush(10000);
}

}  // namespace vestige
