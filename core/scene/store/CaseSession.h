#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"
#include "core/scene/store/Autosaves.h"
#include "core/scene/store/CaseLock.h"
#include "core/scene/store/CaseStore.h"

namespace vestige {

/// Edits that an earlier window did not get to save.
struct Recovered {
    SceneState state;      ///< after the last of them; layers not loaded
    std::string sentence;  ///< "3 changes were not saved (the last: ...)"
};

/// One case open in one window: whether it may be saved, and where its edits are kept until it is. Edits of a
/// store go to its own journal; others, and those that cannot be written there, to the user's own folder. Any
/// thread.
class CaseSession {
  public:
    /// For a case that has no place yet.
    explicit CaseSession(Autosaves autosaves);
    /// For the case at `file`, which is taken for this window; when it cannot be, `readOnly` says why. What
    /// an earlier window left of it comes from `takeRecovered`, once.
    CaseSession(Autosaves autosaves, const std::filesystem::path& file);
    ~CaseSession();

    const std::filesystem::path& place() const { return place_; }
    /// Why the case cannot be saved where it is; empty when it can.
    const std::string& readOnly() const { return readOnly_; }
    std::optional<Recovered> takeRecovered() { return std::exchange(recovered_, std::nullopt); }

    /// Makes an abandoned autosave this session's origin; it is removed once its edits are kept here.
    /// ErrorCode::input, and it stays, when none of its states can be read.
    Status takeOver(const Abandoned& abandoned);

    /// How edits are kept: with the case, in the user's folder because of `problem`, or not at all.
    struct Kept {
        bool kept = true;
        std::string problem;
    };
    /// Keeps edits, together with those that could not be kept before. What `kept` is told for outlasts
    /// everything.
    Kept append(std::vector<CaseEdit> edits);

    /// Saves to the case's own place.
    Status save(const SceneState& state);
    /// The edits since the last save are not wanted any more.
    void discard();

  private:
    Status keepWithUser();
    void removeAutosave();
    void find(const std::filesystem::path& file);

    std::mutex mutex_;
    Autosaves autosaves_;
    std::filesystem::path file_;  ///< as it was named, which layer paths are relative to
    std::filesystem::path place_;
    std::string readOnly_;
    std::unique_ptr<CaseLock> lock_;    ///< of a JSON case; a store has it inside
    std::unique_ptr<CaseStore> store_;  ///< the case itself
    std::unique_ptr<CaseStore> autosave_;
    std::vector<CaseEdit> missed_;  ///< not yet where they belong; the last has the state
    std::size_t inAutosave_ = 0;    ///< of them, already in the user's folder
    std::vector<std::filesystem::path> origins_;
    std::optional<Recovered> recovered_;
    bool dirty_ = false;  ///< there are edits since the last save, or were when it was opened
};

}  // namespace vestige
