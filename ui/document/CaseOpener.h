#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/store/CaseSession.h"

namespace vestige {

/// Takes cases for this window: what Autosave knows for it, as a value that a job carries to its thread. The
/// disk may be slow.
class CaseOpener {
  public:
    /// `present`: the session of the open case.
    CaseOpener(Autosaves autosaves, std::shared_ptr<CaseSession> present)
        : autosaves_(std::move(autosaves)), present_(std::move(present)) {}

    /// The case at `file`; the present session where it is that.
    std::shared_ptr<CaseSession> open(const std::filesystem::path& file) const;
    /// One for a case without a place, that takes over what was left behind. ErrorCode::input when that
    /// cannot be read.
    Result<std::shared_ptr<CaseSession>> takeOver(const Abandoned& abandoned) const;
    /// What windows that are gone left behind, of cases that are not open elsewhere.
    std::vector<Abandoned> abandoned() const { return autosaves_.abandoned(); }

  private:
    Autosaves autosaves_;
    std::shared_ptr<CaseSession> present_;
};

}  // namespace vestige
