#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "core/base/Result.h"
#include "core/scene/store/CaseSession.h"

namespace vestige {

/// One save of a case: what is to be written where, and what became of it. Written by one thread, waited for
/// by another.
class SavingCase {
  public:
    /// `present`: the session of the open case; another place gets a new one.
    SavingCase(Autosaves autosaves, std::shared_ptr<CaseSession> present, std::filesystem::path file,
               SceneState state);

    /// On the writing thread: saves to the present session's place.
    void saveHere();
    /// The same to any place. Where that is the present session's nothing is written but `isHere` is true
    /// then.
    void saveElsewhere();

    /// Before it is tried another way.
    void restart();
    /// Gives it up unless it has begun; false when it has.
    bool giveUp();
    /// Waits for the end; false after that time.
    bool wait(std::chrono::milliseconds most);
    /// Nothing while it is not done.
    std::optional<Status> status() const;
    bool isHere() const { return here_; }
    const std::shared_ptr<CaseSession>& present() const { return present_; }
    /// That holds the saved case; the present one or a new one. After the end.
    const std::shared_ptr<CaseSession>& session() const { return session_; }
    const std::filesystem::path& file() const { return file_; }

    // The waiting thread's notes about the document as it was when it was asked for.
    std::uint64_t step = 0;
    std::uint64_t notes = 0;
    std::uint64_t edit = 0;
    bool here = false;  ///< to be saved by saveHere
    bool left = false;  ///< the document has been replaced since
    std::function<void(const Status&)> done;

  private:
    bool begin();
    void end(Status status);
    Status writeElsewhere(const std::filesystem::path& place);

    Autosaves autosaves_;
    std::shared_ptr<CaseSession> present_;
    std::shared_ptr<CaseSession> session_;
    std::filesystem::path file_;
    SceneState state_;
    mutable std::mutex mutex_;
    std::condition_variable ended_;
    bool begun_ = false;
    bool givenUp_ = false;
    bool here_ = false;
    std::optional<Status> status_;
};

}  // namespace vestige
