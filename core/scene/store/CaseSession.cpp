#include "core/scene/store/CaseSession.h"

#include <iterator>
#include <utility>

#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "core/scene/casefile/CaseText.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// The newest state that can be read.
std::optional<Recovered> recover(const StoredCase& stored, const fs::path& folder) {
    for (const std::string& text : stored.drafts) {
        auto state = sceneFromText(text, (folder / "case.db").string(), folder);
        if (state) return Recovered{std::move(*state), stored.unsavedSentence()};
    }
    return std::nullopt;
}

}  // namespace

CaseSession::CaseSession(Autosaves autosaves) : autosaves_(std::move(autosaves)) {}

CaseSession::CaseSession(Autosaves autosaves, const fs::path& file)
    : autosaves_(std::move(autosaves)), file_(std::filesystem::absolute(file)), place_(casePlace(file)) {
    CaseLock::Refusal refusal;
    auto lock = CaseLock::take(CaseLock::fileFor(place_), refusal);
    readOnly_ = refusal.sentence;
    if (lock && isCaseStore(place_)) {
        std::error_code unknown;
        if (fs::exists(place_ / "case.db", unknown)) {
            auto store = CaseStore::open(place_, std::move(lock));
            if (store)
                store_ = std::move(*store);
            else
                readOnly_ = store.error().sentence();
        } else {
            lock_ =
                std::move(lock);  // a folder from before there were databases; one is made when it is saved
        }
    } else {
        lock_ = std::move(lock);
    }
    // What the other window has not saved is its own affair.
    if (!refusal.elsewhere) find(file);
    dirty_ = recovered_.has_value();
}

CaseSession::~CaseSession() = default;

/// The newer of what the case's own journal and the user's folder hold.
void CaseSession::find(const fs::path& file) {
    StoredCase own;
    if (isCaseStore(place_))
        if (auto stored = readCaseStore(place_)) own = std::move(*stored);
    recovered_ = recover(own, place_);
    if (const auto left = autosaves_.abandonedOf(place_)) {
        // One that cannot be read stays for whoever can make something of it.
        if (auto found = recover(left->content, left->folder)) {
            // An older one, of a window that had the case read-only beside the one whose journal this is,
            // stays and is offered once these edits are saved or discarded.
            if (!recovered_ || left->content.lastMoment > own.lastMoment) {
                origins_.push_back(left->folder);
                recovered_ = std::move(found);
            }
        }
    }
    if (recovered_) recovered_->state.file = file;
}

Status CaseSession::takeOver(const Abandoned& abandoned) {
    const std::scoped_lock one(mutex_);
    recovered_ = recover(abandoned.content, abandoned.folder);
    if (!recovered_)
        return fail(ErrorCode::input, "none of the states that were kept here can be read",
                    abandoned.folder.string());
    origins_.push_back(abandoned.folder);
    return {};
}

Status CaseSession::keepWithUser() {
    if (!autosave_) {
        auto made = autosaves_.create(place_);
        if (!made) return fail(made.error());
        autosave_ = std::move(*made);
    }
    const auto first = missed_.begin() + static_cast<std::ptrdiff_t>(inAutosave_);
    const Status done = autosave_->append({first, missed_.end()});
    if (done) inAutosave_ = missed_.size();
    return done;
}

CaseSession::Kept CaseSession::append(std::vector<CaseEdit> edits) {
    const std::scoped_lock one(mutex_);
    // Only the last state counts; of the others what was done is told.
    if (!missed_.empty() && !edits.empty()) missed_.back().state = SceneState();
    missed_.insert(missed_.end(), std::make_move_iterator(edits.begin()),
                   std::make_move_iterator(edits.end()));
    if (missed_.empty()) return {};
    dirty_ = true;
    Kept result;
    if (const Status kept = store_ ? store_->append(missed_) : keepWithUser(); kept) {
        if (store_) removeAutosave();
        missed_.clear();
        inAutosave_ = 0;
    } else {
        result.problem = kept.error().sentence();
        // A store's edits have a second place; they still go where they belong as soon as that works.
        result.kept = store_ && keepWithUser().has_value();
        if (!result.kept) return result;
    }
    for (const auto& folder : std::exchange(origins_, {})) Autosaves::remove(folder);
    return result;
}

Status CaseSession::save(const SceneState& state) {
    const std::scoped_lock one(mutex_);
    if (!readOnly_.empty())
        return fail(ErrorCode::output, readOnly_, place_.string(), "save it under another name");
    if (isCaseStore(place_) && !store_) {
        auto store = CaseStore::open(place_, std::move(lock_));
        if (!store) {
            // A lock that opening has used up is taken again.
            CaseLock::Refusal refusal;
            lock_ = CaseLock::take(CaseLock::fileFor(place_), refusal);
            return fail(store.error());
        }
        store_ = std::move(*store);
    }
    const Status saved = store_ ? store_->save(state) : writeCase(file_, state);
    if (!saved) return saved;
    missed_.clear();
    inAutosave_ = 0;
    dirty_ = false;
    removeAutosave();
    for (const auto& folder : std::exchange(origins_, {})) Autosaves::remove(folder);
    return {};
}

void CaseSession::discard() {
    const std::scoped_lock one(mutex_);
    missed_.clear();
    inAutosave_ = 0;
    // Where the case cannot be written, the next window offers these edits once more: a pity, no loss.
    if (store_ && dirty_) static_cast<void>(store_->discard());
    dirty_ = false;
    removeAutosave();
    for (const auto& folder : std::exchange(origins_, {})) Autosaves::remove(folder);
}

void CaseSession::removeAutosave() {
    if (!autosave_) return;
    Autosaves::remove(autosave_->folder());
    autosave_.reset();
}

}  // namespace vestige
