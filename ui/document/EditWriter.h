#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "core/scene/store/CaseSession.h"

namespace vestige {

/// Writes edits to their sessions, in order, on a thread of its own. A disk that does not answer holds that
/// thread, and nobody who waits for it longer than he says.
class EditWriter {
  public:
    struct Task {
        std::shared_ptr<CaseSession> session;
        std::vector<CaseEdit> edits;
        bool discard = false;    ///< instead of writing: the session's unsaved edits are forgotten
        std::uint64_t last = 0;  ///< number of the last edit that was made
        std::function<void()> work = nullptr;  ///< instead of writing: done in its turn
    };
    /// What became of the edits up to `last`; after a task's `work`, without a session. Called on the
    /// writer's thread, never after `end`.
    using Tell = std::function<void(const std::shared_ptr<CaseSession>& session,
                                    const CaseSession::Kept& kept, std::uint64_t last)>;

    explicit EditWriter(Tell tell);
    ~EditWriter();

    void add(Task task);
    /// Waits until everything of the session (null: of all) is written or has failed; false after
    /// `milliseconds`.
    bool flush(int milliseconds, const std::shared_ptr<CaseSession>& session = nullptr);
    /// Writes what waits and ends. False after `milliseconds`: what is being written then goes on, as long as
    /// the program lives, and nobody is told.
    bool end(int milliseconds);
    /// The last edit that is known to be kept.
    std::uint64_t kept() const;

  private:
    struct Shared;
    static void work(const std::shared_ptr<Shared>& shared);

    std::shared_ptr<Shared> shared_;  ///< the thread may outlast this object
    std::thread thread_;
};

}  // namespace vestige
