#pragma once

#include "core/base/JobControl.h"

namespace vestige {

/// While it lives, the loops of Parallel.h that this thread begins end with an ErrorException
/// (ErrorCode::cancelled) at the next chunk once the job is cancelled, so that a job stops in loops that know
/// nothing of it: `guarded` makes the error of it where the job ends. Scopes lie within each other; the
/// innermost counts.
class CancelScope {
  public:
    explicit CancelScope(const JobControl& control);
    ~CancelScope();
    CancelScope(const CancelScope&) = delete;
    CancelScope& operator=(const CancelScope&) = delete;

    /// Of this thread; null outside of all scopes.
    static const JobControl* current();

  private:
    JobControl control_;
    const CancelScope* outer_;
};

/// For long loops that are not parallel: throws as they do.
void throwIfCancelled();

}  // namespace vestige
