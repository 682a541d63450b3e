#include "ui/document/SavingCase.h"

#include <system_error>
#include <utility>

#include "core/scene/CaseFile.h"
#include "core/scene/SceneInputs.h"

namespace vestige {

namespace fs = std::filesystem;

SavingCase::SavingCase(Autosaves autosaves, std::shared_ptr<CaseSession> present, fs::path file,
                       SceneState state)
    : autosaves_(std::move(autosaves)),
      present_(std::move(present)),
      file_(std::move(file)),
      state_(std::move(state)) {}

bool SavingCase::begin() {
    const std::scoped_lock lock(mutex_);
    begun_ = true;
    return !givenUp_;
}

void SavingCase::end(Status status) {
    const std::scoped_lock lock(mutex_);
    status_ = std::move(status);
    // Closing a session takes the disk's time: not on the waiting thread.
    if (!here_ && session_ != present_) present_.reset();
    ended_.notify_all();
}

void SavingCase::saveHere() {
    if (!begin()) return;
    session_ = present_;
    end(guarded(file_.string(), [&]() -> Status {
        if (Status apart = isNoInput(state_, file_); !apart) return apart;
        return present_->save(state_);
    }));
}

void SavingCase::saveElsewhere() {
    if (!begin()) return;
    end(guarded(file_.string(), [&]() -> Status {
        if (Status apart = isNoInput(state_, file_); !apart) return apart;
        const fs::path place = casePlace(file_);
        here_ = !present_->place().empty() && place == present_->place();
        return here_ ? Status() : writeElsewhere(place);
    }));
}

Status SavingCase::writeElsewhere(const fs::path& place) {
    const fs::path folder = isCaseStore(place) ? place : place.parent_path();
    std::error_code problem;
    const bool made = fs::create_directories(folder, problem);
    if (problem)
        return fail(ErrorCode::output, "the folder cannot be made: " + problem.message(), folder.string());
    session_ = std::make_shared<CaseSession>(autosaves_, file_);
    Status saved = session_->save(state_);
    if (saved) return saved;
    // Without its lock and what it began to write.
    session_.reset();
    if (made && isCaseStore(place))
        for (const char* name : {"case.db", "case.db-journal"}) fs::remove(place / name, problem);
    if (made) fs::remove(folder, problem);  // if it is empty
    return saved;
}

void SavingCase::restart() {
    const std::scoped_lock lock(mutex_);
    begun_ = false;
    status_.reset();
}

bool SavingCase::giveUp() {
    const std::scoped_lock lock(mutex_);
    givenUp_ = !begun_;
    return givenUp_;
}

bool SavingCase::wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, most, [&] { return status_.has_value(); });
}

std::optional<Status> SavingCase::status() const {
    const std::scoped_lock lock(mutex_);
    return status_;
}

}  // namespace vestige
