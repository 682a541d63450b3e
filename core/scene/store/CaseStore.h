#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"
#include "core/scene/store/CaseLock.h"

namespace vestige {

/// What a store holds.
struct StoredCase {
    std::optional<std::string> saved;  ///< text of the case as it was saved last
    /// Texts after edits that were not saved, newest first: of the last of them and, for when it cannot be
    /// read, some before. Empty when the newest is what was saved.
    std::vector<std::string> drafts;
    std::int64_t unsaved = 0;     ///< edits since the last save; 0 when there are no drafts
    std::string lastEdit;         ///< the newest of them, as "Undo" would call it
    std::string lastTime;         ///< ISO 8601, UTC
    std::int64_t lastMoment = 0;  ///< the same, nanoseconds since 1970
    std::string caseFile;         ///< of an autosave: the case it belongs to; empty: one that was never saved
    bool copyChanged = false;     ///< case.json beside it is not what was saved here

    /// "3 changes were not saved (the last: pick mirror, 2026-11-27T14:02:11Z)".
    std::string unsavedSentence() const;
};

/// Reads the store in `folder`, also while a window has it open, or from a medium that cannot be written.
/// A folder without a database holds nothing. ErrorCode::input when it is damaged.
Result<StoredCase> readCaseStore(const std::filesystem::path& folder);

/// A state of the case after an edit.
struct CaseEdit {
    std::string what;  ///< "pick mirror, repeat 2"
    SceneState state;
};

/// A folder that keeps a case in a database, case.db: the case as it was saved, and the journal of the edits
/// since. What a function has returned success for outlasts kill -9 and power failure. Any thread; one call
/// at a time is done. See docs/decisions/0016-case-store.md.
class CaseStore {
  public:
    /// Opens it to write, making folder and database where they are missing. ErrorCode::output when it cannot
    /// be written or is open elsewhere.
    static Result<std::unique_ptr<CaseStore>> open(const std::filesystem::path& folder);
    /// With a lock that is held already.
    static Result<std::unique_ptr<CaseStore>> open(const std::filesystem::path& folder,
                                                   std::unique_ptr<CaseLock> lock);
    ~CaseStore();

    const std::filesystem::path& folder() const { return folder_; }

    /// Adds edits to the journal, in one step.
    Status append(const std::vector<CaseEdit>& edits);
    /// Makes `state` the saved case; the journal begins anew. A readable copy goes to case.json.
    Status save(const SceneState& state);
    /// Forgets the states since the last save; what was done stays listed.
    Status discard();
    /// For an autosave: the case it belongs to.
    Status setCaseFile(const std::filesystem::path& file);

  private:
    struct Data;
    CaseStore(std::filesystem::path folder, std::unique_ptr<Data> data);
    template <class Work>
    Status attempt(const Work& work);

    std::filesystem::path folder_;
    std::unique_ptr<Data> data_;
};

}  // namespace vestige
